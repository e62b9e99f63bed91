"""What the parts know together: status, alarms, rates, inspection."""

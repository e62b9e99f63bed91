"""Access rules, and who has control."""

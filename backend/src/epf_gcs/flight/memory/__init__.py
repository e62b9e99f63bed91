"""What the flight process remembers in files: settings, the lines of a journal."""

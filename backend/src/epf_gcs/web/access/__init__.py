"""Who may ask, and who has control."""

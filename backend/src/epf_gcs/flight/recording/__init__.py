"""Every byte of both lines into files."""

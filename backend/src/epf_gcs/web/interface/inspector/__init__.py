"""Every message of both lines, measured."""

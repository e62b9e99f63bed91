"""Logs of other programs, read by their own libraries, as topics with the names that they have there."""

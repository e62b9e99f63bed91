"""Recordings: list and download."""

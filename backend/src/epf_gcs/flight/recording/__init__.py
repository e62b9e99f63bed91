"""Recordings of every byte of both lines."""

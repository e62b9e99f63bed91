"""Flights: the library of all recordings, what is in them, and the jobs that make it."""

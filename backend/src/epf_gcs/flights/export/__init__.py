"""Flights as files of other programs: one module a format, each in memory that does not grow with the flight."""

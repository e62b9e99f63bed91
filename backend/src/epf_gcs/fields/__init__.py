"""Prepare a field: heights and pictures of the surroundings of a place, brought before the flight into one file."""

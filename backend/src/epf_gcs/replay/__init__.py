"""A recording flown again: a process of its own that speaks the same stream as the flight process."""

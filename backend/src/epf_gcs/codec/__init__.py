"""Bytes <-> messages of the board's line. No I/O, no clock, no log, no framework."""

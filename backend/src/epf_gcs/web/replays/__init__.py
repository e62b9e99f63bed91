"""Flights of the past on the stream: one replay process for each recording that is looked at."""

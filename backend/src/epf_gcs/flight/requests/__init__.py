"""The requests that a station may make to the flight process: one file for each subject."""

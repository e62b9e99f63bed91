"""Starts the demonstration: board, simulator and gateway as child processes."""

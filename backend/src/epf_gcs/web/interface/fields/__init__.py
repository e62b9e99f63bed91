"""Prepare a field over HTTP."""

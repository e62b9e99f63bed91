"""Measurements beside the peers, in the same run: `python -m bench`."""

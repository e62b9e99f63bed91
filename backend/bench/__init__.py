"""Measurements of the gateway and of comparable programs (peers) in the same run: `python -m bench`."""

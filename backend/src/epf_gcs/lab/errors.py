"""What goes wrong with the lab itself, not with a flight."""

from __future__ import annotations


class LabError(Exception):
    """A flight cannot be flown or judged as asked; the sentence says why, and what to do."""

"""The lab: flies a board's laws in the simulator in lock-step, and judges each flight by what the simulator flew."""

"""The running parts: the only code with tasks and timers."""

"""The status as the web process tells it: whole, with health and metrics."""

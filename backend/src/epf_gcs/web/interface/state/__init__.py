"""Status, newest telemetry, health and metrics over HTTP."""

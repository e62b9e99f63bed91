"""Status, newest telemetry and control over HTTP."""

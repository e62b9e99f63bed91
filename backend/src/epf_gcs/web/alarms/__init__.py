"""The alarms over HTTP."""

"""Setting a station up, over HTTP."""

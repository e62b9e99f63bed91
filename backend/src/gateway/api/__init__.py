"""HTTP and WebSocket: thin, and the only place that knows the web framework."""

"""The WebSocket stream: the newest state and events for any number of viewers."""

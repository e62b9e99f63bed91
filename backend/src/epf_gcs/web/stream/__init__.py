"""The WebSocket stream: newest state and events to any number of viewers."""

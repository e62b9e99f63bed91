"""The web process: interface, stream, page and maps. It owns nothing of the flight."""

"""The web process: REST interface, stream, page and maps. It holds no state of the flight process."""

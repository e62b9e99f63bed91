"""The vehicle as the web process knows it: its newest samples and status."""

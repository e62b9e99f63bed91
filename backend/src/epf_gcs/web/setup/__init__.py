"""Setting a station up: whether that was ever done, and what the doctor finds on this computer."""

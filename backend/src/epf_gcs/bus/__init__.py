"""The small stream between a vehicle's process and those that show it: definition, ends, carrier."""

"""The stream between a vehicle's process and the stations that show it: its records, both ends, and the transport."""

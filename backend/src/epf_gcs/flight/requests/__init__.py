"""What a station may ask of the flight: one file a subject, each with the few parts that it needs."""

"""The format of a recording: its topics, its notes, reading it whole, cut, growing or packed, and packing it."""

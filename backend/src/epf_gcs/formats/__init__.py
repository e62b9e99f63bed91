"""Files of other programs: flight plans and tracks, bytes to values and back. Pure: no disk, no clock."""

"""The simulator's datagrams <-> our units. No I/O, no clock, no log, no framework."""

"""Devices and sockets of board and simulator: the only code that opens, reads and writes them."""

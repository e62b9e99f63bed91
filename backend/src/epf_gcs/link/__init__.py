"""Devices and sockets: the only code that touches one."""

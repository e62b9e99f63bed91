"""The two links and the serial ports over HTTP."""

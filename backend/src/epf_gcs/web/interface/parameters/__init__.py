"""The 17 gains over HTTP."""

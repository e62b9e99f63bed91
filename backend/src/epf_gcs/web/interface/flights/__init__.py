"""The library of flights over HTTP."""

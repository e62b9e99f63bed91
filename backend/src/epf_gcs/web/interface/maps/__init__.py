"""Maps, terrain and online sources over HTTP."""

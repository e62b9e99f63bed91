"""The checklist before take-off over HTTP."""

"""Ground and fence over HTTP."""

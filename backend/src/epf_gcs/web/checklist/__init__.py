"""The checklist before take-off: one for all who fly with this station."""

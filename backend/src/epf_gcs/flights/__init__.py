"""The library of flights: recordings decoded in bulk, their columns, events and figures; runs in worker processes."""

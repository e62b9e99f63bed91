"""Programs that run beside the station: how they are started, asked and ended."""

"""The flown tracks: kept, drawn and exported."""

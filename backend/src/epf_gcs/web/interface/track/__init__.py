"""The flown tracks over HTTP, as files and as points."""

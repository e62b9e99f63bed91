"""Maps that the operator brings: files of tiles and of heights, and online sources with what was seen kept."""

"""Maps of the operator: files of tiles and of heights, and online sources with a cache of their tiles."""

"""Makes the map that ships with the page, from public data in packages: coast, borders, places, airfields, navaids."""

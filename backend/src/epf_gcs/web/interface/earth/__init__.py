"""Google Earth: live link and plans as KML."""

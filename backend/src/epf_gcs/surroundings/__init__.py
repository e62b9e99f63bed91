"""Ground and fence around the aircraft: height above the ground, and warnings of what the present track leads to.

Runs in the web process, which has the heights; the flight process only raises the alarms it is told of.
"""

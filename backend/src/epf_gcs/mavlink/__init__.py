"""The station as a MAVLink 2 vehicle, for ground stations and programs of others."""

"""Versions, licences and the packages in use."""

"""The interface /api/v1: a folder for each subject with its routes and shapes."""

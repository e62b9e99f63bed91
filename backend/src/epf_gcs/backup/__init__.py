"""The data folder as one file: written, encrypted with a password, read back and proven."""

"""The data folder: where it is, which process has it, its format, and how an older one is brought up to date."""

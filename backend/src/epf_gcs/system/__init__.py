"""What differs between Linux, macOS and Windows: one module for each subject, each with all three in it.

Every module can be imported on every system. What a system does not have is left out in silence where nothing is lost
by it (a niceness), and says so by its answer where something is.
"""

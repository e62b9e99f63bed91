"""Why the demonstration cannot start or go on."""


class LaunchError(Exception):
    """One sentence for the person at the terminal: what failed, why, and what to do."""

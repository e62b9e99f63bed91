"""Why a backup cannot be written or read."""


class BackupError(Exception):
    """One sentence for a person: what failed, why, and what to do."""

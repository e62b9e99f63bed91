"""The gateway of EPF GCS: board and simulator on one side, any number of browsers on the other."""

from importlib.metadata import version

__version__ = version("epf-gcs")

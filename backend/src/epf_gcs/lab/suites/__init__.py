"""Suites that judge a board's laws by what the simulator flew: `pytest --pyargs epf_gcs.lab.suites`."""

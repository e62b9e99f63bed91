"""Suites that judge a board's laws by what the simulator flew: `epf-lab test`, or `pytest --pyargs epf_gcs.lab.suites`."""

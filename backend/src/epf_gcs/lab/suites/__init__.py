"""Suites that judge laws by what the simulator flew: `epf-lab test`, or `pytest --pyargs epf_gcs.lab.suites`."""

"""Small changes in the gateway's code, each of which some test should notice: `make mutate`."""

"""Commands, the HIL switches, the console and the AHRS test over HTTP."""

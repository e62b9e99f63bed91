"""The embedded flight simulator: JSBSim that speaks as X-Plane does, as a program of its own."""

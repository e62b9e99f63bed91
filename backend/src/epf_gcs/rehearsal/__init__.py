"""Flies a plan with a model of aircraft and autopilot before it is sent, and says what will go wrong on which leg."""

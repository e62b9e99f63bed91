"""The embedded simulator: JSBSim flight dynamics that speak X-Plane's UDP."""

"""The flight process: lines, HIL, commands with proof, recorder. It knows nothing of HTTP."""

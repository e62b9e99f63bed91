"""What is asked of the board: commands with proof, parameters, plans, the AHRS test."""

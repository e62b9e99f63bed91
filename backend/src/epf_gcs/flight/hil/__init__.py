"""The loop between the simulator and the board, and the pilot's stick."""

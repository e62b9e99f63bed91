"""The HIL loop between simulator and board, and the pilot's stick."""

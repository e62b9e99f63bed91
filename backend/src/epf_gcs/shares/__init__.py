"""What is scarce, and each caller's share of it: one table (`table.py`), two ways to hold it."""

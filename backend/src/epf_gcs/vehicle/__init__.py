"""What is known of the board and its aircraft: values and rules, no I/O, no clock."""

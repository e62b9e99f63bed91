"""What goes wrong in the embedded simulator by order."""

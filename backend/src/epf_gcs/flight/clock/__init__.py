"""Times of the bytes of both lines, and the watch over this computer's clock."""

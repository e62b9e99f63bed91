"""The flight report: figures of a finished flight, the manoeuvres found in it and how the loops answered them."""

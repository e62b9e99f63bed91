"""Ways in, people, programs and control over HTTP."""

"""What passes between the parts, said once in types: shapes of the interface, events."""

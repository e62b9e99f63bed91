"""Flight plans over HTTP and as files."""

"""HTTP: connections, TLS on the same port, the guard of each request, the page's files."""

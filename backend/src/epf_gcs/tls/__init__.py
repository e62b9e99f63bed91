"""TLS on the page's port: certificates, made or brought, and the doorway that tells TLS from plain HTTP."""

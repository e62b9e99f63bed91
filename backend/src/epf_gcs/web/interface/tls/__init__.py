"""The certificate over HTTP."""

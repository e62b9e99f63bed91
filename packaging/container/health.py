"""The image's health check: whether the station's two processes answer. Standard library alone; 0 means well.

It does not ask for the board: a container that is started again because a cable was pulled would end a flight.
"""

from __future__ import annotations

import json
import os
import ssl
import sys
import urllib.error
import urllib.request

_TIMEOUT_S = 4.0


def main() -> int:
    """Ask /health, which tells a stranger no more than this."""
    secure = bool(os.environ.get("GCS_TLS_CERT")) or os.environ.get("GCS_TLS", "").lower() in ("1", "true", "yes", "on")
    url = f"{'https' if secure else 'http'}://127.0.0.1:{os.environ.get('GCS_PORT', '8000')}/health"
    context = ssl.create_default_context() if secure else None
    if context is not None:
        # It is this container's own loopback, and nothing is sent.
        context.check_hostname = False
        context.verify_mode = ssl.CERT_NONE
    try:
        with urllib.request.urlopen(url, timeout=_TIMEOUT_S, context=context) as answer:  # noqa: S310
            body = answer.read()
    except urllib.error.HTTPError as error:
        # 503: some part has failed; which one, the body says.
        body = error.read()
    except OSError as error:
        print(f"no answer at {url}: {error}")
        return 1
    try:
        processes = json.loads(body)["processes"]
    except (ValueError, KeyError, TypeError):
        print(f"no health at {url}")
        return 1
    print(f"processes: {processes}")
    return 0 if processes == "ok" else 1


if __name__ == "__main__":
    sys.exit(main())

"""Whose process is at the other end of a connection, as the kernel tells it."""

from __future__ import annotations

import os
import socket
import sys
from contextlib import closing, suppress

import pytest

from epf_gcs.access.socket_owner import Connection, owner_of

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="Linux alone tells it")


def test_the_other_end_is_ours_however_much_it_has_still_to_send() -> None:
    """Its bytes under way stand beside its user in the kernel's answer."""
    with closing(socket.create_server(("127.0.0.1", 0))) as listener:
        own_host, own_port = listener.getsockname()
        with closing(socket.create_connection((own_host, own_port))) as made:
            accepted, (host, port) = listener.accept()
            with closing(accepted):
                asked = Connection(host, port, own_host, own_port)
                assert owner_of(asked) == os.getuid()
                made.setblocking(False)
                with suppress(BlockingIOError):
                    while True:
                        made.send(bytes(65536))
                assert owner_of(asked) == os.getuid()

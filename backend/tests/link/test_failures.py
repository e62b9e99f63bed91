"""Every reason of the system is one sentence for a person."""

from __future__ import annotations

import errno
import os

import pytest

from epf_gcs.link.failures import link_error, lost_error


@pytest.mark.parametrize(
    ("number", "code"),
    [
        (errno.EACCES, "link_permission"),
        (errno.EBUSY, "link_busy"),
        (errno.ENXIO, "link_no_device"),
        (errno.EADDRINUSE, "port_taken"),
        (errno.ETIMEDOUT, "link_timeout"),
        (errno.EHOSTUNREACH, "link_unreachable"),
        (errno.EIO, "link_failed"),
    ],
)
def test_the_sentence_names_the_device_and_what_to_do(number: int, code: str) -> None:
    error = link_error("/dev/ttyUSB0", OSError(number, os.strerror(number)))
    assert error.code == code
    assert "/dev/ttyUSB0" in error.detail
    assert ": " in error.detail
    assert error.detail.endswith(".")
    assert error.params["target"] == "/dev/ttyUSB0"


def test_a_lost_line_says_why_and_that_it_comes_back() -> None:
    error = lost_error("/dev/ttyUSB0", "Input/output error")
    assert "Input/output error" in error.detail
    assert "opened again" in error.detail

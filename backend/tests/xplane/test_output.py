"""What X-Plane is told, byte by byte."""

from __future__ import annotations

import pytest

from epf_gcs.xplane.output import output_datagrams


def test_it_is_told_where_to_which_and_how_often() -> None:
    target, rows, rate = output_datagrams("192.168.1.5", 49003, [20, 3])
    assert target == b"ISE4\0" + b"\x40\0\0\0" + b"192.168.1.5".ljust(16, b"\0") + b"49003\0\0\0" + b"\x01\0\0\0"
    assert rows == b"DSEL\0" + b"\x03\0\0\0" + b"\x14\0\0\0"
    assert rate.startswith(b"DREF\0\x00\x00\x48\x42sim/network/dataout/network_data_rate\0")
    assert len(rate) == 509


@pytest.mark.parametrize("host", ["sim-pc", "fe80::1", "", "1234.1234.1234.1234"])
def test_a_name_is_no_address(host: str) -> None:
    with pytest.raises(ValueError, match="no IPv4 address"):
        output_datagrams(host, 49003, [3])

"""From an address to an open link."""

from __future__ import annotations

from epf_gcs.link.address import LinkAddress
from epf_gcs.link.descriptor import DescriptorLink
from epf_gcs.link.serial import open_pty, open_serial
from epf_gcs.link.tcp import open_tcp


async def open_link(address: LinkAddress) -> DescriptorLink:
    """Open the device; nothing is read until `start`. Raises LinkError with the reason in one sentence."""
    if address.scheme == "tcp":
        device = await open_tcp(address)
    else:
        device = open_pty(address) if address.scheme == "pty" else open_serial(address)
    return DescriptorLink(device)

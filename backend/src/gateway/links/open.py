"""From an address to an open link."""

from __future__ import annotations

from gateway.links.address import LinkAddress
from gateway.links.descriptor import DescriptorLink
from gateway.links.serial import open_pty, open_serial
from gateway.links.tcp import open_tcp


async def open_link(address: LinkAddress) -> DescriptorLink:
    """Open the device; nothing is read until `start`. Raises LinkError with the reason in one sentence."""
    if address.scheme == "tcp":
        device = await open_tcp(address)
    else:
        device = open_pty(address) if address.scheme == "pty" else open_serial(address)
    return DescriptorLink(device)

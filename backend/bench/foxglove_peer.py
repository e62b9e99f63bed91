"""The peer: a gateway made with foxglove-sdk, as its documentation shows it.

A thread reads the line, the same decoder finds the frames, and each is logged as JSON to the SDK's server.
Run as a program: `python -m bench.foxglove_peer PTY`; prints its port.
"""

from __future__ import annotations

import json
import os
import sys

import foxglove
from foxglove import Channel, Schema

from bench.station import WebSocket
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.codec.values import meaning

NAME = "foxglove-sdk"
_PROTOCOLS = ("foxglove.sdk.v1", "foxglove.websocket.v1")


def main() -> None:
    """Read the line forever."""
    server = foxglove.start_server(host="127.0.0.1", port=0)
    schema = Schema(name="values", encoding="jsonschema", data=b'{"type":"object"}')
    channels: dict[str, Channel] = {"ahrs": Channel("ahrs", schema=schema, message_encoding="json")}
    print(server.port, flush=True)
    fd = os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY)
    decoder = FrameDecoder()
    while True:
        for found in decoder.feed(os.read(fd, 65536)):
            if isinstance(found, Frame):
                name = found.message.name
                if name not in channels:
                    channels[name] = Channel(name, schema=schema, message_encoding="json")
                channels[name].log(json.dumps(meaning(found).values).encode())


def subscribe(port: int) -> WebSocket:
    """A client that gets the channel `ahrs`."""
    client = WebSocket(port, "/", _PROTOCOLS[0])
    while True:
        message = client.receive()
        if message[:1] != b"{":
            continue
        told = json.loads(message)
        for channel in told.get("channels", ()):
            if channel["topic"] == "ahrs":
                client.send(json.dumps({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": channel["id"]}]}))
                return client


if __name__ == "__main__":
    main()

"""Peers as they are: one that repeats itself, one that lies, one that does not read, and too many of them."""

from __future__ import annotations

import asyncio
from typing import Any

from epf_gcs.mavlink.dialect import MAKE, WIRE
from epf_gcs.mavlink.peers import Peer, Peers, TcpPeer

KEY = bytes(range(32))


def wire(signing_key: bytes | None = None) -> Any:
    made = WIRE.MAVLink(None, 255, 190)
    if signing_key is not None:
        made.signing.secret_key = signing_key
        made.signing.sign_outgoing = True
    return made


def asked(sender: Any) -> bytes:
    return bytes(MAKE.param_request_list_encode(1, 1).pack(sender))


def kinds(messages: list[Any]) -> list[str]:
    return [message.get_type() for message in messages]


def test_a_frame_that_comes_twice_at_once_is_heard_once() -> None:
    peer = Peer(lambda _: None, None)
    frame = asked(wire())
    assert kinds(peer.hear(frame + frame, 0.0)) == ["PARAM_REQUEST_LIST"]
    assert kinds(peer.hear(frame, 0.5)) == []


def test_a_station_that_was_started_again_is_heard_although_it_numbers_from_the_beginning() -> None:
    peer = Peer(lambda _: None, None)
    frame = asked(wire())
    assert len(peer.hear(frame, 0.0)) == len(peer.hear(frame, 5.0)) == 1


def test_damage_is_counted_and_the_next_good_frame_is_heard() -> None:
    peer = Peer(lambda _: None, None)
    damaged = bytearray(asked(wire()))
    damaged[-1] ^= 0xFF
    second = wire()
    second.seq = 1
    assert kinds(peer.hear(b"noise" + bytes(damaged) + asked(second), 0.0)) == ["PARAM_REQUEST_LIST"]
    assert peer.damaged > 0


def test_with_a_signing_key_only_what_is_signed_with_it_is_heard() -> None:
    def heard(sender: Any) -> int:
        return len(Peer(lambda _: None, KEY).hear(asked(sender), 0.0))

    assert (heard(wire(KEY)), heard(wire()), heard(wire(bytes(32)))) == (1, 0, 0)


def test_what_is_sent_is_signed_and_numbered_for_each_peer() -> None:
    sent: list[bytes] = []
    peer = Peer(sent.append, KEY)
    for _ in range(300):
        peer.send(MAKE.mission_current_encode(0))
    receiver = wire(KEY)
    numbers = [message.get_seq() for frame in sent for message in receiver.parse_buffer(frame)]
    assert numbers == [number % 256 for number in range(300)]


def test_there_is_room_for_a_new_peer_when_a_silent_one_has_gone() -> None:
    now_s = [0.0]
    heard: list[str] = []
    peers = Peers(lambda _, message: heard.append(message.get_type()), lambda: now_s[0], None)
    sender = wire()
    for key in range(9):
        peers.hear(key, asked(sender), lambda _: None)
    assert len(heard) == 8
    now_s[0] = 60.0
    peers.hear(8, asked(sender), lambda _: None)
    assert len(heard) == 9


def test_a_peer_that_does_not_read_is_left() -> None:
    async def flood() -> bool:
        loop = asyncio.get_running_loop()
        peers = Peers(lambda *_: None, loop.time, None)
        server = await loop.create_server(lambda: TcpPeer(peers), "127.0.0.1", 0)
        port = server.sockets[0].getsockname()[1]
        reader, writer = await asyncio.open_connection("127.0.0.1", port, limit=1)
        # It reads nothing: the system's buffers fill up, then ours.
        while not reader.at_eof() and writer.transport.is_closing() is False:
            for _ in range(1000):
                peers.send(MAKE.statustext_encode(6, b"x" * 50))
            await asyncio.sleep(0)
            if not peers.count:
                break
        writer.close()
        server.close()
        return peers.count == 0

    assert asyncio.run(flood())

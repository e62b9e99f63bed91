"""Certificates for tests, clients that speak TLS, and a doorway on a loop of its own."""

from __future__ import annotations

import asyncio
import socket
import ssl
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any, cast
from urllib.parse import urlsplit, urlunsplit

import uvloop
from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec, rsa
from cryptography.x509.oid import NameOID
from websockets.sync.client import ClientConnection, connect

from epf_gcs.shares.table import SHARES, Shares
from epf_gcs.tls.keeper import Keeper
from epf_gcs.web.serving.doorway import Doorway
from epf_gcs.web.serving.visitors import Limits, Visitor, Visitors
from tests.support.waiting import DEADLINE_S, eventually_async

_WINDOW_BYTES = 65536

_Streams = tuple[asyncio.StreamReader, asyncio.StreamWriter]

LOOPS: dict[str, Callable[[], asyncio.AbstractEventLoop]] = {
    "uvloop": uvloop.new_event_loop,
    "asyncio": asyncio.new_event_loop,
}


def self_signed(
    folder: Path,
    *,
    kind: str = "ec",
    begins: datetime | None = None,
    ends: datetime | None = None,
    name: str = "brought",
) -> tuple[Path, Path]:
    """A certificate as a user brings it, and its key, in two files. `kind` is ec, or the bits of an RSA key."""
    key = ec.generate_private_key(ec.SECP256R1()) if kind == "ec" else rsa.generate_private_key(65537, int(kind))
    now = datetime.now(UTC)
    subject = x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, name)])
    certificate = (
        x509.CertificateBuilder()
        .subject_name(subject)
        .issuer_name(subject)
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(begins or now - timedelta(days=1))
        .not_valid_after(ends or now + timedelta(days=60))
        .add_extension(x509.SubjectAlternativeName([x509.DNSName("station.example")]), critical=False)
        .sign(key, hashes.SHA256())
    )
    files = folder / f"{name}.crt", folder / f"{name}.key"
    files[0].write_bytes(certificate.public_bytes(serialization.Encoding.PEM))
    files[1].write_bytes(private_pem(key))
    return files


def private_pem(key: ec.EllipticCurvePrivateKey | rsa.RSAPrivateKey, password: bytes | None = None) -> bytes:
    """A private key in PEM, as `openssl pkey` writes it."""
    lock = serialization.NoEncryption() if password is None else serialization.BestAvailableEncryption(password)
    return key.private_bytes(serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, lock)


def trusting(authority: Path) -> ssl.SSLContext:
    """A browser that trusts this authority alone."""
    return ssl.create_default_context(cafile=authority)


def trust_in(keeper: Keeper) -> ssl.SSLContext:
    """A browser that trusts what this station shows: its authority, or the brought certificate whatever its name."""
    found = keeper.in_use.found
    trusted = found.authority or found.certificate
    context = ssl.create_default_context(cadata=trusted.public_bytes(serialization.Encoding.PEM).decode())
    context.check_hostname = found.authority is not None
    context.verify_flags |= ssl.VERIFY_X509_PARTIAL_CHAIN
    return context


def careless() -> ssl.SSLContext:
    """A client that takes any certificate."""
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    return context


def shake_hands(client: ssl.SSLContext, server: ssl.SSLContext, name: str | None = None) -> ssl.SSLObject:
    """The client's end of a handshake in memory. Raises ssl.SSLError of whichever end refuses."""
    to_server, to_client = ssl.MemoryBIO(), ssl.MemoryBIO()
    theirs = server.wrap_bio(to_server, to_client, server_side=True)
    ours = client.wrap_bio(to_client, to_server, server_hostname=name)
    waiting = [ours, theirs]
    while waiting:
        for end in tuple(waiting):
            try:
                end.do_handshake()
                waiting.remove(end)
            except ssl.SSLWantReadError:
                pass
    return ours


class Door:
    """A doorway and what it has seen, on a loop in a thread."""

    def __init__(self, loop: asyncio.AbstractEventLoop, listener: socket.socket, visitors: Visitors) -> None:
        self.loop = loop
        self.port = int(listener.getsockname()[1])
        self.visitors = visitors

    def connect(self) -> socket.socket:
        """A TCP connection that has not said anything yet."""
        return socket.create_connection(("127.0.0.1", self.port), timeout=DEADLINE_S)

    def connect_tls(self, context: ssl.SSLContext, name: str = "127.0.0.1") -> ssl.SSLSocket:
        """A connection after its handshake."""
        made = self.connect()
        try:
            return context.wrap_socket(made, server_hostname=name)
        except BaseException:
            made.close()
            raise


class Echo(asyncio.Protocol):
    """Sends back what comes, behind its name."""

    def __init__(self, name: bytes) -> None:
        self._name = name
        self._transport: asyncio.Transport | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self._transport = cast(asyncio.Transport, transport)

    def data_received(self, data: bytes) -> None:
        assert self._transport is not None
        self._transport.write(self._name + data)


@contextmanager
def open_door(
    kind: str,
    context: ssl.SSLContext | Callable[[], ssl.SSLContext],
    *,
    encrypted: Callable[[], asyncio.Protocol] = lambda: Echo(b"encrypted "),
    plain: Callable[[], asyncio.Protocol] = lambda: Echo(b"plain "),
    limits: Limits | None = None,
    shares: Shares = SHARES,
    listener: socket.socket | None = None,
) -> Iterator[Door]:
    """A doorway to two protocols on a loop of LOOPS; everything that it reports to its loop fails the test."""
    loop = LOOPS[kind]()
    listener = listener or socket.create_server(("127.0.0.1", 0), backlog=512)
    visitors = Visitors(limits, shares)
    door = Door(loop, listener, visitors)
    faults: list[object] = []
    open_now: set[asyncio.Protocol] = set()
    loop.set_exception_handler(lambda _, fault: faults.append(fault))
    ready, end = threading.Event(), asyncio.Event()

    def handed_over(make: Callable[[], asyncio.Protocol]) -> Callable[[Visitor], asyncio.Protocol]:
        def made(arrival: Visitor) -> asyncio.Protocol:
            protocol = make()
            begun, lost = protocol.connection_made, protocol.connection_lost

            def connection_made(transport: asyncio.BaseTransport) -> None:
                visitors.leave(arrival)
                open_now.add(protocol)
                begun(transport)

            def connection_lost(exc: Exception | None) -> None:
                open_now.discard(protocol)
                lost(exc)

            protocol.connection_made = connection_made  # type: ignore[method-assign]
            protocol.connection_lost = connection_lost  # type: ignore[method-assign]
            return protocol

        return made

    async def serve() -> None:
        asker = context if callable(context) else lambda: context
        doorway = Doorway(listener, asker, handed_over(encrypted), handed_over(plain), visitors=visitors)
        ready.set()
        await end.wait()
        doorway.close()
        await doorway.wait_closed()
        await eventually_async(lambda: not open_now, "all connections end, for the test has closed its ends")
        await asyncio.sleep(0)

    def run() -> None:
        asyncio.set_event_loop(loop)
        loop.run_until_complete(serve())
        loop.close()

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    assert ready.wait(DEADLINE_S)
    try:
        yield door
    finally:
        loop.call_soon_threadsafe(end.set)
        thread.join(DEADLINE_S)
        listener.close()
    assert not thread.is_alive()
    assert faults == [], faults


@contextmanager
def connected(address: str, trust: ssl.SSLContext | None, **options: Any) -> Iterator[ClientConnection]:
    """A client of a stream, in plain text where there is no `trust`.

    This client reads and writes in two threads, and before Python 3.13 two threads that use one TLS object at the same
    time can spoil it: a request is lost, or a write never returns. So one thread alone speaks TLS for it.
    """
    if trust is None:
        with connect(address, max_size=None, **options) as connection:
            yield connection
        return
    url = urlsplit(address)
    with (
        _decrypted(str(url.hostname), int(url.port or 443), trust) as plain,
        connect(urlunsplit(url._replace(scheme="ws")), max_size=None, sock=plain, **options) as connection,
    ):
        yield connection


@contextmanager
def _decrypted(host: str, port: int, trust: ssl.SSLContext) -> Iterator[socket.socket]:
    """A socket for plain text to the TLS server there; the loop of one thread encrypts, decrypts and passes on."""
    ours, theirs = socket.socketpair()
    loop = asyncio.new_event_loop()
    thread = threading.Thread(target=loop.run_forever, daemon=True)
    thread.start()

    async def begin() -> asyncio.Task[None]:
        # A small and fixed window: what a slow reader leaves waits with the server, and not in the system's memory.
        raw = socket.socket()
        raw.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, _WINDOW_BYTES)
        raw.setblocking(False)
        await asyncio.get_running_loop().sock_connect(raw, (host, port))
        server = await asyncio.open_connection(sock=raw, ssl=trust, server_hostname=host)
        client = await asyncio.open_connection(sock=theirs)
        return asyncio.create_task(pass_on(client, server))

    async def pass_on(client: _Streams, server: _Streams) -> None:
        both = [asyncio.create_task(copy(client[0], server[1])), asyncio.create_task(copy(server[0], client[1]))]
        await asyncio.wait(both, return_when=asyncio.FIRST_COMPLETED)
        # TLS has no half-closed connection: where one side ends, both do, after what is on its way.
        for _, writer in (client, server):
            writer.close()
        await asyncio.gather(*both, *(writer.wait_closed() for _, writer in (client, server)), return_exceptions=True)

    async def copy(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        while data := await reader.read(65536):
            writer.write(data)
            await writer.drain()

    try:
        with closing(ours):
            passing = asyncio.run_coroutine_threadsafe(begin(), loop).result(DEADLINE_S)
            yield ours
        asyncio.run_coroutine_threadsafe(asyncio.wait_for(passing, DEADLINE_S), loop).result()
    finally:
        loop.call_soon_threadsafe(loop.stop)
        thread.join(DEADLINE_S)
        theirs.close()
        loop.close()

"""Each share filled by strangers of sixty addresses, and guests with right keys who come meanwhile.

Runs in a network namespace of its own (`unshare`, `ip`), so that the strangers have addresses that are not this
computer's. `shares:handshakes` fills one of them alone. `python -m bench.shares FOLDER NAME...` is the inside of it.
"""

from __future__ import annotations

import contextlib
import json
import re
import selectors
import socket
import ssl
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from http.client import HTTPConnection, HTTPException, HTTPSConnection
from pathlib import Path
from typing import Any, Final, NamedTuple

from bench.table import Row
from epf_gcs.access.invitations import new_invitation
from epf_gcs.access.moment import Moment
from epf_gcs.access.roles import Role
from epf_gcs.access.store import AccessStore
from epf_gcs.shares.holder import Standing
from epf_gcs.shares.table import SHARES
from tests.replay.recordings import flight, write

STATION: Final = "10.231.0.1"
STRANGERS: Final = [f"10.231.1.{number}" for number in range(1, 61)]
GUESTS: Final = [f"10.231.2.{number}" for number in range(1, 11)]
REACH_GUEST_S: Final = 2.0
REACH_EXPORT_S: Final = 5.0
_NAMES: Final = ("bodies", "answers", "handshakes", "streams", "jobs", "asks", "marks")
_FILLING_S: Final = 4.0
_GUEST_TRIES_S: Final = 15.0
_FLIGHT: Final = "20260101T120000Z"
_ENTER: Final = "/api/v1/access/enter"


def run(only: str = "") -> list[Row]:
    """How long a guest with a right key takes under each attack, and an owner's export while viewers fill the jobs."""
    with tempfile.TemporaryDirectory() as folder:
        inside = [sys.executable, "-m", "bench.shares", folder, *([only] if only else _NAMES)]
        addresses = " && ".join(
            ["ip link set lo up", *(f"ip addr add {one}/16 dev lo" for one in (STATION, *STRANGERS, *GUESTS))]
        )
        unshare = ["unshare", "--map-root-user", "--net", "sh", "-c", f'{addresses} && exec "$@"', "sh"]
        answer = subprocess.run([*unshare, *inside], stdout=subprocess.PIPE, check=True, text=True)
    return [Row(**row) for row in json.loads(answer.stdout)]


class Station(NamedTuple):
    """A station that others reach, and its certificate's authority where it speaks TLS."""

    port: int
    folder: Path
    trust: ssl.SSLContext | None

    def key(self, role: Role) -> str:
        """A one-time key, as `epf-gcs invite` makes one."""
        with contextlib.closing(AccessStore(self.folder)) as store:
            return new_invitation(store, role, 60.0, Moment.now())[0]

    def connect(self, address: str, timeout_s: float = 5.0) -> HTTPConnection:
        """A client of this address."""
        source = (address, 0)
        if self.trust is None:
            return HTTPConnection(STATION, self.port, timeout=timeout_s, source_address=source)
        return HTTPSConnection(STATION, self.port, timeout=timeout_s, source_address=source, context=self.trust)

    def ask(self, address: str, method: str, path: str, body: Any = None, cookie: str = "") -> tuple[int, Any, str]:
        """One request on a connection of its own: status, answer and the cookie that it sets. Raises OSError."""
        with contextlib.closing(self.connect(address)) as client:
            headers = {"Content-Type": "application/json", **({"Cookie": cookie} if cookie else {})}
            client.request(method, path, None if body is None else json.dumps(body), headers)
            answer = client.getresponse()
            data = answer.read()
            is_json = "json" in (answer.getheader("Content-Type") or "")
            set_cookie = (answer.getheader("Set-Cookie") or "").partition(";")[0]
            return answer.status, json.loads(data) if is_json else data, set_cookie

    def enter(self, address: str, role: Role, name: str = "Ana") -> str:
        """Enter with a right key, trying again when the line breaks; the cookie. Raises TimeoutError."""
        key, give_up_s = self.key(role), time.monotonic() + _GUEST_TRIES_S
        while time.monotonic() < give_up_s:
            with contextlib.suppress(OSError, HTTPException):
                status, _, cookie = self.ask(address, "POST", _ENTER, {"key": key, "name": name})
                if status == 200:
                    return cookie
            time.sleep(0.05)
        raise TimeoutError("the guest did not get in")


@contextlib.contextmanager
def station(folder: Path, *, tls: bool) -> Iterator[Station]:
    """A station that listens on all addresses, has a flight, and takes nobody for this computer."""
    (folder / "recordings").mkdir(parents=True)
    write(folder / "recordings" / f"{_FLIGHT}.mcap", flight(600.0))
    words = [sys.executable, "-m", "epf_gcs.launcher.gateway", "--lan", "--port", "0", "--data-dir", str(folder)]
    process = subprocess.Popen([*words, *(["--tls"] if tls else [])], stderr=subprocess.PIPE, text=True)
    try:
        assert process.stderr is not None
        found = None
        while found is None:
            found = re.search(r"url=https?://[^ ]+:(\d+)", process.stderr.readline())
        threading.Thread(target=process.stderr.read, daemon=True).start()
        trust = ssl.create_default_context(cafile=str(folder / "tls" / "authority.crt")) if tls else None
        yield Station(int(found[1]), folder, trust)
    finally:
        process.terminate()
        process.wait()


Attack = Callable[[Station, threading.Event], None]


@contextlib.contextmanager
def under(attack: Attack, made: Station) -> Iterator[None]:
    """The attack goes on meanwhile, and did for some seconds before."""
    end = threading.Event()
    thread = threading.Thread(target=attack, args=(made, end), daemon=True)
    thread.start()
    time.sleep(_FILLING_S)
    try:
        yield
    finally:
        end.set()
        thread.join()


def _hold(made: Station, end: threading.Event, beginning: bytes, each: int, drip: bytes = b"") -> None:
    """So many connections of each stranger that begin so and read nothing; those that were ended begin again."""
    open_now: dict[socket.socket, str] = {}
    missing = [address for address in STRANGERS for _ in range(each)]
    waiting = selectors.DefaultSelector()
    while not end.is_set():
        for address in missing[:200]:
            with contextlib.suppress(OSError):
                line = socket.socket()
                line.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
                line.bind((address, 0))
                line.settimeout(0.2)
                line.connect((STATION, made.port))
                line.setblocking(False)
                line.send(beginning)
                open_now[line] = address
                waiting.register(line, selectors.EVENT_READ)
        del missing[:200]
        end.wait(0.05)
        for key, _ in waiting.select(0.0):
            line = key.fileobj  # type: ignore[assignment]
            waiting.unregister(line)
            line.close()
            missing.append(open_now.pop(line))
        for line in tuple(open_now) if drip else ():
            with contextlib.suppress(OSError):
                line.send(drip)
    for line in open_now:
        line.close()


def _bodies(made: Station, end: threading.Event) -> None:
    """Bodies that come slowly, but steadily."""
    head = (
        f"POST {_ENTER} HTTP/1.1\r\nHost: {STATION}\r\nContent-Type: application/json\r\nContent-Length: 60000\r\n\r\n"
    )
    _hold(made, end, head.encode() + b" ", 20, b" " * 110)


def _answers(made: Station, end: threading.Event) -> None:
    """Answers that nobody reads."""
    _hold(made, end, f"GET /index.html HTTP/1.1\r\nHost: {STATION}\r\n\r\n".encode() * 100, 20)


def _hello() -> bytes:
    """A ClientHello, as a browser would send it."""
    incoming, outgoing = ssl.MemoryBIO(), ssl.MemoryBIO()
    with contextlib.suppress(ssl.SSLWantReadError):
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
        context.wrap_bio(incoming, outgoing, server_hostname=STATION).do_handshake()
    return outgoing.read()


def _handshakes(made: Station, end: threading.Event) -> None:
    """TLS handshakes that are begun over and over, ten a second by each stranger."""
    hello = _hello()
    while not end.is_set():
        for address in STRANGERS:
            with contextlib.suppress(OSError), socket.socket() as line:
                line.bind((address, 0))
                line.settimeout(0.02)
                line.connect((STATION, made.port))
                line.send(hello)
                line.recv(1)
        end.wait(0.01)


def _streams(made: Station, end: threading.Event) -> None:
    """One viewer's key that opens and closes streams as fast as it can."""
    cookie = made.enter(STRANGERS[0], Role.viewer, "Eve")
    head = (
        f"GET /api/v1/stream HTTP/1.1\r\nHost: {STATION}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        f"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\nCookie: {cookie}\r\n\r\n"
    )
    while not end.is_set():
        line = socket.socket()
        with contextlib.suppress(OSError), line:
            line.bind((STRANGERS[0], 0))
            line.settimeout(1.0)
            line.connect((STATION, made.port))
            line.sendall(head.encode())
            line.recv(4096)


def _jobs(made: Station, end: threading.Event) -> None:
    """Viewers who ask for exports of a long flight as fast as they can."""
    cookies = [made.enter(address, Role.viewer, "Eve") for address in STRANGERS[:10]]
    while not end.is_set():
        for address, cookie in zip(STRANGERS, cookies, strict=False):
            with contextlib.suppress(OSError, HTTPException):
                made.ask(address, "POST", f"/api/v1/flights/{_FLIGHT}/exports", {"format": "csv"}, cookie)


def _asks(made: Station, end: threading.Event) -> None:
    """Strangers who ask to be let in."""
    while not end.is_set():
        for address in STRANGERS:
            with contextlib.suppress(OSError, HTTPException):
                made.ask(address, "POST", "/api/v1/access/ask", {"name": "Eve"})


def _marks(made: Station, end: threading.Event) -> None:
    """A viewer who marks a flight as fast as it can."""
    cookie = made.enter(STRANGERS[0], Role.viewer, "Eve")
    while not end.is_set():
        with contextlib.suppress(OSError, HTTPException):
            mark = {"text": "x" * 500, "at_s": 1.0}
            made.ask(STRANGERS[0], "POST", f"/api/v1/flights/{_FLIGHT}/marks", mark, cookie)


_ATTACKS: Final[dict[str, Attack]] = {
    "bodies": _bodies,
    "answers": _answers,
    "handshakes": _handshakes,
    "streams": _streams,
    "jobs": _jobs,
    "asks": _asks,
    "marks": _marks,
}


def _measure(name: str, folder: Path) -> list[dict[str, Any]]:
    """Guests of ten addresses enter one after another under this attack; then what else the attack is about."""
    with station(folder, tls=name == "handshakes") as made:
        owner = made.enter(GUESTS[0], Role.owner, "Boss")
        while made.ask(GUESTS[0], "GET", f"/api/v1/flights/{_FLIGHT}", cookie=owner)[1]["state"] != "indexed":
            time.sleep(0.5)
        with under(_ATTACKS[name], made):
            took_s = []
            for address in GUESTS:
                begun_s = time.monotonic()
                made.enter(address, Role.viewer)
                took_s.append(time.monotonic() - begun_s)
            what = f"strangers fill {name}: a guest with a right key is in, slowest of {len(GUESTS)}"
            rows = [_row(what, max(took_s), "s", REACH_GUEST_S)]
            if name == "jobs":
                what = "viewers fill jobs: an owner's export begins"
                rows.append(_row(what, _export_s(made, owner), "s", REACH_EXPORT_S))
            if name == "asks":
                status, _, _ = made.ask(GUESTS[1], "POST", "/api/v1/access/ask", {"name": "Eva"})
                rows.append(_row("strangers fill asks: the answer to a guest without a key", status, "", 200))
        if name == "marks":
            _, events, _ = made.ask(GUESTS[0], "GET", f"/api/v1/flights/{_FLIGHT}/events", cookie=owner)
            count = sum(event["kind"] == "mark" for event in events["events"])
            most = SHARES.marks.parts[Standing.viewer].each
            rows.append(_row("a viewer's marks in one flight", count, "", most))
    return rows


def _export_s(made: Station, owner: str) -> float:
    begun_s = time.monotonic()
    _, job, _ = made.ask(GUESTS[0], "POST", f"/api/v1/flights/{_FLIGHT}/exports", {"format": "gpx"}, owner)
    while made.ask(GUESTS[0], "GET", f"/api/v1/jobs/{job['job']}", cookie=owner)[1]["state"] == "waiting":
        time.sleep(0.02)
    return time.monotonic() - begun_s


def _row(what: str, ours: float, unit: str, most: float) -> dict[str, Any]:
    return {"what": what, "ours": ours, "unit": unit, "reach": f"<= {most:g} {unit}".rstrip(), "ok": ours <= most}


if __name__ == "__main__":
    found = [row for name in sys.argv[2:] for row in _measure(name, Path(sys.argv[1]) / name)]
    print(json.dumps(found))

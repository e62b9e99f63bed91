"""Where others reach the station, and the codes that a phone reads."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from pydantic import ValidationError

from epf_gcs.access.addresses import _outward_address, addresses
from epf_gcs.access.roles import Role
from epf_gcs.tls.identity import addresses_by_interface
from epf_gcs.web.serving.settings import Settings
from tests.support.callers import person, strict_gateway
from tests.support.gateway import Gateway, running_gateway

OUTSIDE = "http://station.example:9000"


@pytest.fixture
def contained(tmp_path: Path) -> Iterator[Gateway]:
    """As in a container: what the others see cannot be seen from inside."""
    with strict_gateway(tmp_path / "data", reached_at=OUTSIDE) as gateway:
        yield gateway


def test_what_the_user_said_comes_first_in_addresses_and_invitations(contained: Gateway) -> None:
    with person(contained, Role.owner) as owner:
        assert owner.get("/access/addresses").json()["addresses"][0] == OUTSIDE
        made = owner.post("/access/invitations", json={"tab": "map"}).json()
        assert made["address"] == f"{OUTSIDE}/#key={made['key']}&tab=map"
        assert made["qr_svg"].startswith("<svg")
        assert owner.get("/status", headers={"Host": "station.example:9000"}).status_code == 200
        assert owner.get("/status", headers={"Host": "other.example"}).json()["code"] == "foreign_host"


def test_the_certificate_is_for_it_too(tmp_path: Path) -> None:
    with running_gateway(tmp_path / "data", tls=True, reached_at="https://[fd00::7]:9000") as gateway:
        assert "fd00::7" in gateway.http.get("/access/certificates").json()["certificate"]["addresses"]


@pytest.mark.parametrize(
    ("listens_on", "numbers"),
    [
        ("0.0.0.0", ["http://192.168.1.5:8000"]),  # noqa: S104 - nothing listens
        ("::", ["http://[fd00::2]:8000"]),
        ("fd00::2", ["http://[fd00::2]:8000"]),
        ("fe80::1%eth0", []),  # no browser takes a zone in a URL
        ("169.254.7.7", ["http://169.254.7.7:8000"]),
        ("127.0.0.1", []),
        ("::1", []),
    ],
)
def test_only_addresses_at_which_the_station_answers_a_browser_are_told(
    monkeypatch: pytest.MonkeyPatch, listens_on: str, numbers: list[str]
) -> None:
    here = [("eth0", number) for number in ("127.0.0.1", "::1", "192.168.1.5", "fd00::2", "fe80::1%eth0")]
    monkeypatch.setattr("epf_gcs.access.addresses.addresses_by_interface", lambda: here)
    told = addresses(listens_on, 8000, secure=False)
    assert [address for address in told if not address.endswith(".local:8000")] == numbers
    if listens_on == "fe80::1%eth0":
        assert len(told) == 1  # by its name it is reached all the same


@pytest.mark.parametrize(
    ("outward", "order"),
    [
        ("192.168.1.5", ["192.168.1.5", "10.0.0.7", "172.17.0.1", "10.8.0.2"]),
        # A private network that has taken the default route is not where the phones are.
        ("10.8.0.2", ["10.0.0.7", "192.168.1.5", "10.8.0.2", "172.17.0.1"]),
        (None, ["10.0.0.7", "192.168.1.5", "172.17.0.1", "10.8.0.2"]),
    ],
)
def test_the_network_of_the_default_route_is_told_first_and_virtual_ones_last(
    monkeypatch: pytest.MonkeyPatch, outward: str | None, order: list[str]
) -> None:
    here = [("docker0", "172.17.0.1"), ("eth0", "10.0.0.7"), ("tun0", "10.8.0.2"), ("wlan0", "192.168.1.5")]
    monkeypatch.setattr("epf_gcs.access.addresses.addresses_by_interface", lambda: here)
    monkeypatch.setattr("epf_gcs.access.addresses._outward_address", lambda _: outward)
    told = addresses("0.0.0.0", 8000, secure=False)  # noqa: S104 - nothing listens
    assert [one for one in told if not one.endswith(".local:8000")] == [f"http://{number}:8000" for number in order]


def test_the_way_out_is_an_address_of_this_machine_or_unknown() -> None:
    own = {number for _, number in addresses_by_interface()}
    for version in (4, 6):
        assert _outward_address(version) in {None, *own}


@pytest.mark.parametrize(
    "wrong", ["station.example", "ftp://x", "http://x/path", "http://a@b", "http://x:1:2", "javascript://x", "http://"]
)
def test_what_is_no_address_is_refused_at_the_start(tmp_path: Path, wrong: str) -> None:
    with pytest.raises(ValidationError):
        Settings(data_dir=tmp_path, reached_at=wrong)


def test_a_viewer_gets_the_code_of_a_plain_address_and_of_the_authority(contained: Gateway) -> None:
    with person(contained, Role.viewer) as ana:
        codes = [
            ana.get("/access/code", params={"address": address, **more}, headers={"Host": address[7:]})
            for address in (OUTSIDE, "http://station.example")
            for more in ({}, {"tab": "map"}, {"to": "authority"})
        ]
        assert {code.headers["content-type"] for code in codes} == {"image/svg+xml"}
        assert len({code.content for code in codes}) == 6


@pytest.mark.parametrize("host", ["127.0.0.1", "localhost", "[::1]"])
def test_no_code_is_drawn_of_an_address_that_no_other_computer_could_follow(tmp_path: Path, host: str) -> None:
    with running_gateway(tmp_path / "data") as gateway:
        host = f"{host}:{gateway.base.rpartition(':')[2]}"
        gateway.http.headers["Host"] = host
        assert gateway.http.get("/access/addresses").json()["addresses"] == []
        made = gateway.http.post("/access/invitations", json={}).json()
        assert (made["address"], made["qr_svg"]) == (f"http://{host}/#key={made['key']}", None)
        answer = gateway.http.get("/access/code", params={"address": f"http://{host}"})
        assert (answer.status_code, answer.json()["code"]) == (422, "invalid_request")


@pytest.mark.parametrize("address", ["http://evil.example", "javascript:alert(1)", "", f"{OUTSIDE}/#key=x"])
def test_the_station_draws_no_code_that_leads_elsewhere(contained: Gateway, address: str) -> None:
    with person(contained, Role.viewer) as ana:
        answer = ana.get("/access/code", params={"address": address})
        assert (answer.status_code, answer.json()["code"]) == (422, "invalid_request")


@pytest.mark.parametrize(
    "address", ["http://evil.example", "javascript:alert(1)", "", f"{OUTSIDE}/", f"{OUTSIDE}@evil"]
)
def test_no_invitation_leads_elsewhere_and_none_is_made(contained: Gateway, address: str) -> None:
    with person(contained, Role.owner) as owner:
        answer = owner.post("/access/invitations", json={"address": address})
        assert (answer.status_code, answer.json()["code"]) == (422, "invalid_request")
        assert owner.get("/access/invitations").json()["invitations"] == []


@pytest.mark.parametrize("is_announced", [True, False])
def test_the_machine_s_name_is_told_only_where_something_answers_for_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, *, is_announced: bool
) -> None:
    monkeypatch.setattr("sys.platform", "linux")
    monkeypatch.setattr("epf_gcs.access.addresses._AVAHI", tmp_path if is_announced else tmp_path / "nowhere")
    told = addresses("0.0.0.0", 8000, secure=False)  # noqa: S104 - nothing listens
    assert any(address.endswith(".local:8000") for address in told) is is_announced

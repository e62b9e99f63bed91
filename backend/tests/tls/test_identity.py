"""Which names and addresses a certificate has to hold."""

from __future__ import annotations

import ipaddress

import ifaddr
import pytest

from epf_gcs.tls.identity import a_label, addresses_here, identity_of


@pytest.mark.parametrize(
    ("name", "label"),
    [
        ("Station", "station"),
        ("müller", "xn--mller-kva"),
        ("Müller.Local.", "xn--mller-kva.local"),
        ("mu\u0308ller", "xn--mller-kva"),  # the same umlaut as two characters
        ("straße", "xn--strae-oqa"),  # not `strasse`, as in the older IDNA2003
        ("avión-2", "xn--avin-2-dxa"),
        ("a b", None),
        ("under_score", None),
        ("-begins", None),
        ("☃", None),
        ("", None),
        ("a..b", None),
        ("x" * 64, None),
        (".".join(["x" * 60] * 5), None),
    ],
)
def test_a_name_is_written_as_browsers_send_it(name: str, label: str | None) -> None:
    assert a_label(name) == label


def test_the_machine_is_known_by_its_name_with_and_without_local_and_by_all_addresses() -> None:
    found = identity_of("Müller.fritz.box", [], ["192.168.1.20", "fd00::2", "fe80::1%eth0"])
    assert found.own == ("xn--mller-kva.local", "xn--mller-kva", "localhost")
    assert found.chosen == ()
    assert [str(one) for one in found.addresses] == ["127.0.0.1", "::1", "192.168.1.20", "fd00::2", "fe80::1"]


def test_chosen_names_and_numbers_are_told_apart_and_nonsense_is_left_out() -> None:
    everywhere = "0.0.0.0"  # noqa: S104 - no address that anybody could ask for
    found = identity_of("pc", [everywhere, "::", "Club.Example", "10.0.0.7", "[fd00::7]", "no name", "pc.local"], [])
    assert found.chosen == ("club.example",)
    assert [str(one) for one in found.addresses] == ["127.0.0.1", "::1", "10.0.0.7", "fd00::7"]


def test_a_machine_without_a_usable_name_is_localhost() -> None:
    assert identity_of("???", [], []).own == ("localhost",)


def test_addresses_of_both_versions_are_found_without_their_zones(monkeypatch: pytest.MonkeyPatch) -> None:
    ips = [
        ifaddr.IP("192.168.1.20", 24, "eth0"),
        ifaddr.IP(("fd00::2", 0, 0), 64, "eth0"),
        ifaddr.IP(("fe80::1", 0, 2), 64, "eth0"),
    ]
    monkeypatch.setattr(ifaddr, "get_adapters", lambda: [ifaddr.Adapter("eth0", "eth0", ips)])
    assert addresses_here() == ["192.168.1.20", "fd00::2", "fe80::1"]


def test_this_machine_has_its_loopback() -> None:
    found = addresses_here()
    assert "127.0.0.1" in found
    assert all(ipaddress.ip_address(one) for one in found)

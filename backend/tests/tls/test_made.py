"""The station's own certificates in its data folder: rights, damage, renewal."""

from __future__ import annotations

import os
import stat
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from epf_gcs.tls.certificates import STATION_DAYS, addresses_of
from epf_gcs.tls.identity import identity_of
from epf_gcs.tls.made import AUTHORITY, AUTHORITY_CERTIFICATE, STATION, OwnCertificate

NOW = datetime.now(UTC)


class Machine:
    """A machine whose addresses the test changes."""

    def __init__(self, folder: Path) -> None:
        self.addresses = ["192.168.1.20"]
        self.chosen: list[str] = []
        self.folder = folder / "tls"
        self.made = OwnCertificate(self.folder, lambda: identity_of("pc", self.chosen, self.addresses))

    def rights(self, name: str) -> int:
        return stat.S_IMODE((self.folder / name).stat().st_mode)


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    return Machine(tmp_path)


def test_keys_can_be_read_by_their_owner_alone(machine: Machine) -> None:
    before = os.umask(0)
    try:
        machine.made.find(NOW)
    finally:
        os.umask(before)
    assert machine.rights(".") == 0o700
    assert machine.rights(AUTHORITY) == 0o600
    assert machine.rights(STATION) == 0o600
    assert b"PRIVATE" not in (machine.folder / AUTHORITY_CERTIFICATE).read_bytes()


def test_rights_that_a_copy_lost_are_taken_back(machine: Machine) -> None:
    machine.made.find(NOW)
    for name in (AUTHORITY, STATION):
        (machine.folder / name).chmod(0o644)
    machine.made.find(NOW)
    assert [machine.rights(name) for name in (AUTHORITY, STATION)] == [0o600, 0o600]


def test_what_is_there_is_used_again(machine: Machine) -> None:
    first = machine.made.find(NOW)
    again = Machine(machine.folder.parent).made.find(NOW + timedelta(days=20))
    assert (again.certificate, again.authority) == (first.certificate, first.authority)


def test_a_machine_that_changed_its_address_gets_a_new_certificate_of_the_same_authority(machine: Machine) -> None:
    first = machine.made.find(NOW)
    machine.addresses = ["10.42.0.1", "fd00::9"]
    second = machine.made.find(NOW)
    assert second.authority == first.authority
    assert [str(one) for one in addresses_of(second.certificate)] == ["127.0.0.1", "::1", "10.42.0.1", "fd00::9"]
    machine.addresses = ["10.42.0.1"]
    assert machine.made.find(NOW).certificate == second.certificate


def test_it_is_renewed_in_time_and_the_authority_stays(machine: Machine) -> None:
    first = machine.made.find(NOW)
    later = machine.made.find(NOW + timedelta(days=STATION_DAYS - 1))
    assert later.certificate != first.certificate
    assert later.authority == first.authority


def test_a_chosen_name_that_the_authority_may_not_sign_needs_a_new_one(machine: Machine) -> None:
    first = machine.made.find(NOW)
    machine.chosen = ["club.example"]
    second = machine.made.find(NOW)
    assert second.authority != first.authority
    assert second.authority is not None
    second.certificate.verify_directly_issued_by(second.authority)


@pytest.mark.parametrize("name", [AUTHORITY, STATION])
def test_a_damaged_file_is_made_again_and_kept_beside_it(machine: Machine, name: str) -> None:
    machine.made.find(NOW)
    (machine.folder / name).write_bytes(b"no certificate")
    found = machine.made.find(NOW)
    assert found.authority is not None
    found.certificate.verify_directly_issued_by(found.authority)
    assert (machine.folder / f"{name}.damaged").read_bytes() == b"no certificate"
    assert machine.made.find(NOW) == found


def test_the_authoritys_certificate_for_people_is_always_the_authoritys(machine: Machine) -> None:
    machine.made.find(NOW)
    (machine.folder / AUTHORITY_CERTIFICATE).write_bytes(b"another")
    machine.made.find(NOW)
    assert (machine.folder / AUTHORITY_CERTIFICATE).read_bytes() in (machine.folder / AUTHORITY).read_bytes()

"""The certificate in use is replaced without a restart, and a fault is said and leaves the old one in use."""

from __future__ import annotations

import shutil
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.tls.brought import GivenCertificate
from epf_gcs.tls.certificates import STATION_DAYS, fingerprint_of
from epf_gcs.tls.identity import identity_of
from epf_gcs.tls.keeper import Keeper
from epf_gcs.tls.made import AUTHORITY_CERTIFICATE, OwnCertificate
from tests.support.tls import self_signed, shake_hands, trusting

pytestmark = pytest.mark.anyio


class Clock:
    def __init__(self) -> None:
        self.now = datetime.now(UTC)

    def __call__(self) -> datetime:
        return self.now


class Kept:
    """A keeper of made certificates, and what it said."""

    def __init__(self, folder: Path, age_days: float = 0.0) -> None:
        self.folder = folder / "tls"
        self.addresses = ["192.168.1.20"]
        self.clock = Clock()
        self.clock.now -= timedelta(days=age_days)
        self.keeper = Keeper(OwnCertificate(self.folder, lambda: identity_of("pc", [], self.addresses)), self.clock)
        self.said: list[str] = []
        self.keeper.on_fault = lambda fault: self.said.append(fault.code)

    def fault(self) -> str:
        """Its sentence, empty if there is none."""
        return "" if self.keeper.fault is None else self.keeper.fault.detail

    def opens(self, name: str) -> bytes | None:
        """A phone that trusts the authority opens this address: the certificate that it is shown."""
        phone = trusting(self.folder / AUTHORITY_CERTIFICATE)
        return shake_hands(phone, self.keeper.context, name).getpeercert(binary_form=True)


@pytest.fixture
def kept(tmp_path: Path) -> Kept:
    return Kept(tmp_path)


async def test_a_machine_that_changed_its_address_is_found_at_the_new_one(kept: Kept) -> None:
    before = kept.opens("192.168.1.20")
    kept.addresses = ["10.42.0.1"]
    with pytest.raises(OSError, match="mismatch"):
        kept.opens("10.42.0.1")
    await kept.keeper.look()
    assert kept.opens("10.42.0.1") != before
    assert kept.keeper.in_use.addresses == ["127.0.0.1", "::1", "10.42.0.1"]


async def test_it_is_renewed_before_its_end(tmp_path: Path) -> None:
    kept = Kept(tmp_path, STATION_DAYS - 5)
    before = kept.keeper.in_use.fingerprint
    await kept.keeper.look()
    assert kept.keeper.in_use.fingerprint == before
    kept.clock.now += timedelta(days=STATION_DAYS - 5)
    await kept.keeper.look()
    assert kept.keeper.in_use.fingerprint != before
    assert kept.opens("pc.local") is not None
    assert kept.keeper.fault is None


async def test_a_renewal_that_fails_is_said_each_hour_and_the_old_one_stays(kept: Kept) -> None:
    before = kept.opens("192.168.1.20")
    away = kept.folder.with_name("away")
    kept.folder.rename(away)
    kept.folder.write_bytes(b"a file where the folder was")
    for _ in range(3):
        await kept.keeper.look()
    assert kept.said == ["tls_not_renewed"]
    assert str(kept.folder) in kept.fault()
    kept.clock.now += timedelta(hours=1)
    await kept.keeper.look()
    await kept.keeper.look()
    assert kept.said == ["tls_not_renewed"] * 2
    kept.folder.unlink()
    shutil.move(away, kept.folder)
    assert kept.opens("192.168.1.20") == before
    await kept.keeper.look()
    assert kept.fault() == ""
    assert kept.said == ["tls_not_renewed"] * 2


async def test_a_station_that_cannot_make_one_says_why_and_where(tmp_path: Path) -> None:
    (tmp_path / "tls").write_bytes(b"a file in the folder's place")
    with pytest.raises(GatewayError, match=f"write to {tmp_path}") as caught:
        Kept(tmp_path)
    assert caught.value.code == "tls_not_renewed"


async def test_brought_files_that_are_replaced_are_used_without_a_restart(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path)
    keeper = Keeper(GivenCertificate(certificate, key))
    said: list[str] = []
    keeper.on_fault = lambda fault: said.append(fault.code)
    before = keeper.in_use.fingerprint
    newer = self_signed(tmp_path, kind="2048", name="newer")
    shutil.copy(newer[0], certificate)
    await keeper.look()
    assert keeper.in_use.fingerprint == before, "the key is not there yet"
    assert said == ["tls_key_differs"]
    shutil.copy(newer[1], key)
    await keeper.look()
    assert keeper.in_use.fingerprint != before
    assert keeper.fault is None
    shown = shake_hands(trusting(certificate), keeper.context, "station.example")
    assert shown.getpeercert(binary_form=True) is not None
    assert keeper.in_use.fingerprint == fingerprint_of(keeper.in_use.found.certificate)


async def test_an_ended_certificate_does_not_take_the_place_of_a_good_one(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path)
    keeper = Keeper(GivenCertificate(certificate, key))
    before = keeper.in_use.fingerprint
    now = datetime.now(UTC)
    ended = self_signed(tmp_path, begins=now - timedelta(days=9), ends=now - timedelta(days=3), name="ended")
    for new, old in zip(ended, (certificate, key), strict=True):
        shutil.copy(new, old)
    await keeper.look()
    assert keeper.in_use.fingerprint == before
    assert keeper.fault is not None
    assert keeper.fault.code == "tls_certificate_expired"

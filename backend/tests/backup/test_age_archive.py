"""Files are those of age: what rage opened is opened, whatever its length, and no damage is taken for content."""

from __future__ import annotations

import base64
import io
import random
from typing import Final

import pytest

from epf_gcs.backup.age_archive import EncryptedReader, EncryptedWriter, is_encrypted
from epf_gcs.backup.errors import BackupError

PASSWORD: Final = "contraseña larga"  # noqa: S105
# The library rage (pyrage 1.4.0) opened these very bytes with that password.
OPENED_BY_RAGE: Final = base64.b64decode(
    "YWdlLWVuY3J5cHRpb24ub3JnL3YxCi0+IHNjcnlwdCBrUHh6V2tVU2JENVdJU1hpN3psWWhBIDEwCncxamxxUTYxNjhmZTM4cTM3OHJVbjVDWXZQMUNz"
    "YXc2UWxXNzg2S3hWTncKLS0tIERaVjBjM252ZWdpL0hndVowZVZkbG9rbFh1Z2Y2VVI5eHpQbHVkSXNSSWMK5S1nhP3AmycO6ibzB1AWjJUiA7Tti+Pq"
    "WAbisvPBXRfTmQv620i42n0HnOM70+OMnI8="
)
CHUNK: Final = 64 * 1024


def encrypted(plain: bytes, piece: int = 10_000) -> bytes:
    file = io.BytesIO()
    writer = EncryptedWriter(file, PASSWORD, work=10)
    for at in range(0, len(plain), piece):
        writer.write(plain[at : at + piece])
    writer.finish()
    return file.getvalue()


def decrypted(sealed: bytes, password: str = PASSWORD, piece: int = -1) -> bytes:
    reader = EncryptedReader(io.BytesIO(sealed), password, "station.tar.age")
    return b"".join(iter(lambda: reader.read(piece), b""))


def test_what_rage_opened_is_opened_here() -> None:
    assert decrypted(OPENED_BY_RAGE) == b"data of a station\n"


@pytest.mark.parametrize("length", [0, 1, CHUNK - 1, CHUNK, CHUNK + 1, 2 * CHUNK, 3 * CHUNK + 5])
@pytest.mark.parametrize("piece", [999, CHUNK, 1 << 20])
def test_content_of_any_length_comes_back_however_it_is_cut(length: int, piece: int) -> None:
    plain = random.Random(length).randbytes(length)
    sealed = encrypted(plain, piece)
    assert is_encrypted(io.BytesIO(sealed))
    assert decrypted(sealed, piece=piece) == plain
    assert len(sealed) < length + 16 * (length // CHUNK + 2) + 250


def test_a_wrong_password_is_told_from_damage() -> None:
    with pytest.raises(BackupError, match="password is wrong"):
        decrypted(OPENED_BY_RAGE, "contraseña corta")


@pytest.mark.parametrize("cut", [0, 10, 60, 120, 180, 210, 217, 225, 250, 300, CHUNK + 260, 2 * CHUNK])
def test_a_file_that_was_cut_off_is_refused(cut: int) -> None:
    with pytest.raises(BackupError, match="cut off or damaged"):
        decrypted(encrypted(bytes(2 * CHUNK + 9))[:cut])


def test_a_file_cut_between_two_chunks_is_refused() -> None:
    sealed = encrypted(bytes(2 * CHUNK))
    with pytest.raises(BackupError, match="cut off or damaged"):
        decrypted(sealed[: -(CHUNK + 16)])


@pytest.mark.parametrize("at", range(0, len(OPENED_BY_RAGE), 3))
def test_no_changed_byte_is_taken_for_content(at: int) -> None:
    changed = bytearray(OPENED_BY_RAGE)
    changed[at] ^= 1
    with pytest.raises(BackupError):
        decrypted(bytes(changed))


def test_a_file_that_asks_for_more_work_than_a_station_can_do_is_refused() -> None:
    with pytest.raises(BackupError, match="more work"):
        decrypted(OPENED_BY_RAGE.replace(b" 10\n", b" 30\n"))

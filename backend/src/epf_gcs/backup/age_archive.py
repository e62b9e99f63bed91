"""A file encrypted with a password in the format of age (https://age-encryption.org/v1), read and written as a stream.

Any program of age opens it: `age -d -o station.tar station.tar.age`. The format is written here, upon the primitives of
`cryptography`, because the libraries of age for Python know passwords only for content that is whole in memory, and
choose the work of scrypt by a stopwatch: on a busy computer it comes out too weak, and their own file may be refused
later as too much work. Here the work is always that of the program age.
"""

from __future__ import annotations

import base64
import binascii
import hashlib
import hmac
import io
import os
import re
from typing import BinaryIO, Final

from cryptography.exceptions import InvalidTag
from cryptography.hazmat.primitives.ciphers.aead import ChaCha20Poly1305
from cryptography.hazmat.primitives.hashes import SHA256
from cryptography.hazmat.primitives.kdf.hkdf import HKDF

from epf_gcs.backup.errors import BackupError

FIRST_LINE: Final = b"age-encryption.org/v1\n"
WORK: Final = 18
"""Base 2 logarithm of scrypt's N, as age has it: 256 MB and about a second, for each password that is tried."""
_MOST_WORK: Final = 20  # 1 GB: what a stranger's file may ask of us
_LABEL: Final = b"age-encryption.org/v1/scrypt"
_CHUNK_BYTES: Final = 64 * 1024
_TAG_BYTES: Final = 16
_KEY_BYTES: Final = 16
_NONCE_BYTES: Final = 16
_STANZA: Final = re.compile(rb"-> scrypt ([A-Za-z0-9+/]{22}) ([1-9][0-9]?)\n")
_LONGEST_LINE: Final = 100

_WRONG_PASSWORD: Final = "The password is wrong."  # noqa: S105 - a sentence
_DAMAGED: Final = "is cut off or damaged"


def is_encrypted(file: BinaryIO) -> bool:
    """Whether a file begins as one of age does. Leaves the file at its beginning. Raises OSError."""
    found = file.read(len(FIRST_LINE)) == FIRST_LINE
    file.seek(0)
    return found


class EncryptedWriter(io.RawIOBase):
    """Encrypts what is written into it; the file is whole only after `finish`."""

    def __init__(self, file: BinaryIO, password: str, work: int | None = None) -> None:
        """`work`: by default WORK. Raises OSError."""
        work = WORK if work is None else work
        file_key, salt, nonce = os.urandom(_KEY_BYTES), os.urandom(16), os.urandom(_NONCE_BYTES)
        wrapped = _wrapping(password, salt, work).encrypt(bytes(12), file_key, None)
        header = FIRST_LINE + b"-> scrypt %s %d\n%s\n---" % (_encoded(salt), work, _encoded(wrapped))
        file.write(header + b" " + _encoded(_mac(file_key, header)) + b"\n" + nonce)
        self._file = file
        self._chunks = _Chunks(file_key, nonce)
        self._rest = bytearray()

    def writable(self) -> bool:
        """Yes."""
        return True

    def write(self, data: bytes) -> int:  # type: ignore[override]
        """Take all of it. Raises OSError."""
        self._rest += data
        while len(self._rest) > _CHUNK_BYTES:  # a full chunk is kept back: it may be the last
            self._file.write(self._chunks.encrypt(bytes(self._rest[:_CHUNK_BYTES]), is_last=False))
            del self._rest[:_CHUNK_BYTES]
        return len(data)

    def finish(self) -> None:
        """Write the last chunk, by which a reader knows that nothing is missing. Raises OSError."""
        self._file.write(self._chunks.encrypt(bytes(self._rest), is_last=True))
        self._rest.clear()


class EncryptedReader(io.RawIOBase):
    """Decrypts a file as it is read. What it gives is what was written; that all of it was read is known at the end."""

    def __init__(self, file: BinaryIO, password: str, name: str) -> None:
        """`name`: what errors call the file. Raises BackupError for a wrong password or a damaged head, OSError."""
        self._file = file
        self._name = name
        header = file.readline(_LONGEST_LINE)
        stanza, wrapped, end = (file.readline(_LONGEST_LINE) for _ in range(3))
        found = _STANZA.fullmatch(stanza)
        if header != FIRST_LINE or found is None or not end.startswith(b"--- "):
            raise BackupError(f"{name} is not encrypted with a password, or {_DAMAGED}: nothing was changed.")
        work = int(found[2])
        if work > _MOST_WORK:
            raise BackupError(f"{name} asks for more work than this station does for a password: nothing was changed.")
        try:
            file_key = _wrapping(password, _decoded(found[1]), work).decrypt(bytes(12), _decoded(wrapped[:-1]), None)
        except InvalidTag as error:
            raise BackupError(f"{_WRONG_PASSWORD} Nothing was changed.") from error
        except ValueError as error:
            raise self._damage() from error
        if end[4:] != _encoded(_mac(file_key, header + stanza + wrapped + b"---")) + b"\n":
            raise self._damage()
        nonce = file.read(_NONCE_BYTES)
        if len(nonce) < _NONCE_BYTES:
            raise self._damage()
        self._chunks = _Chunks(file_key, nonce)
        self._next = file.read(_CHUNK_BYTES + _TAG_BYTES)
        self._plain = b""
        self._is_over = False

    def readable(self) -> bool:
        """Yes."""
        return True

    def read(self, size: int = -1) -> bytes:
        """As many bytes as asked for, fewer only at the end. Raises BackupError where it is damaged, OSError."""
        parts, wanted = [], size
        while wanted != 0:
            if not self._plain:
                if self._is_over:
                    break
                self._plain = self._chunk()
                continue
            part = self._plain if wanted < 0 else self._plain[:wanted]
            self._plain = self._plain[len(part) :]
            parts.append(part)
            wanted -= len(part) if wanted > 0 else 0
        return b"".join(parts)

    def _chunk(self) -> bytes:
        sealed, self._next = self._next, self._file.read(_CHUNK_BYTES + _TAG_BYTES)
        self._is_over = not self._next
        try:
            return self._chunks.decrypt(sealed, is_last=self._is_over)
        except InvalidTag as error:
            raise self._damage() from error

    def _damage(self) -> BackupError:
        return BackupError(f"{self._name} {_DAMAGED}: nothing was changed.")


class _Chunks:
    """Seals and opens chunks in their order; the number of a chunk and whether it is the last are part of its seal."""

    def __init__(self, file_key: bytes, nonce: bytes) -> None:
        self._cipher = ChaCha20Poly1305(_derived(file_key, nonce, b"payload"))
        self._number = 0

    def encrypt(self, plain: bytes, *, is_last: bool) -> bytes:
        return self._cipher.encrypt(self._nonce(is_last=is_last), plain, None)

    def decrypt(self, sealed: bytes, *, is_last: bool) -> bytes:
        return self._cipher.decrypt(self._nonce(is_last=is_last), sealed, None)

    def _nonce(self, *, is_last: bool) -> bytes:
        number, self._number = self._number, self._number + 1
        return number.to_bytes(11, "big") + bytes([is_last])


def _wrapping(password: str, salt: bytes, work: int) -> ChaCha20Poly1305:
    cost = 1 << work
    key = hashlib.scrypt(
        password.encode(), salt=_LABEL + salt, n=cost, r=8, p=1, maxmem=2048 * cost + (1 << 20), dklen=32
    )
    return ChaCha20Poly1305(key)


def _derived(file_key: bytes, salt: bytes, purpose: bytes) -> bytes:
    return HKDF(SHA256(), 32, salt, purpose).derive(file_key)


def _mac(file_key: bytes, header: bytes) -> bytes:
    return hmac.digest(_derived(file_key, b"", b"header"), header, "sha256")


def _encoded(data: bytes) -> bytes:
    return base64.b64encode(data).rstrip(b"=")


def _decoded(text: bytes) -> bytes:
    """Raises ValueError."""
    try:
        return base64.b64decode(text + b"=" * (-len(text) % 4), validate=True)
    except binascii.Error as error:
        raise ValueError(str(error)) from error

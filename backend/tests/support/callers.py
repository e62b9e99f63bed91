"""Strangers, people and programs that ask a running gateway."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Self

import httpx

from epf_gcs.access.guessing import GuessLimiter
from epf_gcs.access.invitations import new_invitation
from epf_gcs.access.moment import Moment
from epf_gcs.access.roles import Role
from epf_gcs.access.store import AccessStore
from tests.support.gateway import Gateway, running_gateway
from tests.support.waiting import DEADLINE_S


@contextmanager
def strict_gateway(data_dir: Path, **settings: Any) -> Iterator[Gateway]:
    """A gateway that trusts nobody on the loopback: each request is a stranger's unless it has a key."""
    with running_gateway(data_dir, trust_this_computer=False, **settings) as gateway:
        yield gateway


def one_time_key(gateway: Gateway, role: Role, minutes: float = 60.0) -> str:
    """As `epf-gcs invite` makes one."""
    with contextlib.closing(AccessStore(gateway.flight_thread.data_dir)) as store:
        return new_invitation(store, role, minutes, Moment.now())[0]


class Browser(httpx.Client):
    """A client that may have asked before it is used with `with`."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def stranger(gateway: Gateway, **headers: str) -> Browser:
    """A client without cookies. All tests ask from one address, so failures of others before it are forgotten."""
    gateway.web.admission.guessing = GuessLimiter()
    return Browser(base_url=f"{gateway.base}/api/v1", timeout=DEADLINE_S, headers=headers)


def person(gateway: Gateway, role: Role, name: str = "Ana") -> Browser:
    """A browser that has entered."""
    client = stranger(gateway)
    body = {"key": one_time_key(gateway, role), "name": name, "place": "tableta"}
    client.post("/access/enter", json=body).raise_for_status()
    return client


def program(gateway: Gateway, role: Role, owner: httpx.Client, name: str = "logger") -> tuple[Browser, str, str]:
    """A program with a key; its client, its key and its id."""
    made = owner.post("/access/programs", json={"name": name, "role": role.name}).raise_for_status().json()
    return stranger(gateway, Authorization=f"Bearer {made['key']}"), made["key"], made["program"]["id"]

"""The whole interface against its own description, with requests that nobody would think of."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, Phase, given, settings

from epf_gcs.access.roles import Role
from epf_gcs.web.docs import OPENAPI_PATH
from epf_gcs.web.serving.access_table import ROUTES
from tests.support.callers import Browser, person, program, stranger, strict_gateway
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway, running_gateway
from tests.support.quick_doctor import QuickDoctor
from tests.support.waiting import DEADLINE_S

pytestmark = pytest.mark.uncounted

# Enough for each pass; `make fuzz-interface` asks more of the same.
EXAMPLES = int(os.environ.get("INTERFACE_EXAMPLES", "8"))
EXAMPLES_BY_ROLE = int(os.environ.get("INTERFACE_EXAMPLES", "3"))
# What closes a link or keeps the board from listening comes last, so that all else is asked of a station with a board.
OPERATIONS = sorted(
    (key for key in ROUTES if key[1].startswith("/api/v1/") and key[1] != OPENAPI_PATH),
    key=lambda operation: (operation[0] == "DELETE" or operation[1].endswith("/ahrs-test"), operation),
)


@pytest.fixture(scope="module")
def flying(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    """One gateway with a board for all requests."""
    folder: Path = tmp_path_factory.mktemp("openapi")
    with FakeBoard(folder / "board") as board, running_gateway(folder / "data") as gateway:
        gateway.open_board(board.url)
        gateway.web.doctor = QuickDoctor()
        yield gateway


@pytest.fixture(scope="module")
def described(flying: Gateway) -> Any:
    # Here: it takes a second, and every worker reads this file.
    import schemathesis
    from schemathesis.config import SchemathesisConfig

    # Keys and cookies that it makes up are strangers': who asks is chosen here.
    config = SchemathesisConfig.from_dict({"generation": {"with-security-parameters": False}})
    return schemathesis.openapi.from_url(f"{flying.base}{OPENAPI_PATH}", config=config, timeout=DEADLINE_S)


def asked(examples: int) -> settings:
    """The same so many requests in every run, however long each takes."""
    return settings(
        max_examples=examples,
        deadline=None,
        derandomize=True,
        suppress_health_check=list(HealthCheck),
        phases=[Phase.explicit, Phase.generate],
    )


@pytest.mark.parametrize(("method", "path"), OPERATIONS)
def test_every_answer_is_as_described(described: Any, method: str, path: str) -> None:
    from schemathesis.specs.openapi.checks import ignored_auth, positive_data_acceptance

    # The range of a value depends on the command's name, and an address on what is plugged in: no schema can say that.
    # Nor that this computer needs no key.
    beyond = [positive_data_acceptance, ignored_auth]

    @asked(EXAMPLES)
    @given(case=described[path][method].as_strategy())
    def ask(case: Any) -> None:
        case.call_and_validate(excluded_checks=beyond, timeout=DEADLINE_S)

    ask()


ROLES = ("stranger", *(role.name for role in Role))


@pytest.fixture(scope="module")
def strict(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Gateway, dict[str, Browser]]]:
    """A gateway that trusts nobody, and a client of each role. Programs, because a person could leave."""
    folder: Path = tmp_path_factory.mktemp("strict")
    with strict_gateway(folder / "data") as gateway, person(gateway, Role.owner) as owner:
        gateway.web.doctor = QuickDoctor()
        clients = {role.name: program(gateway, role, owner, role.name)[0] for role in Role}
        for client in clients.values():
            client.get("/status").raise_for_status()
        clients["stranger"] = stranger(gateway)
        yield gateway, clients
        for client in clients.values():
            client.close()


@pytest.mark.parametrize(("method", "path"), OPERATIONS)
def test_no_request_makes_it_fail_or_gives_a_role_what_it_may_not(
    described: Any, strict: tuple[Gateway, dict[str, Browser]], method: str, path: str
) -> None:
    gateway, clients = strict
    entry = ROUTES[method, path]

    @asked(EXAMPLES_BY_ROLE)
    @given(case=described[path][method].as_strategy())
    def ask(case: Any) -> None:
        for name in ROLES:
            gateway.web.limits._requests._own.clear()  # a stranger may not ask so much at once
            asked = case.as_transport_kwargs(base_url=gateway.base)
            asked["headers"].pop("X-Client", None)
            client = clients[name]
            answer = client.request(
                asked["method"],
                asked["url"],
                params=asked.get("params"),
                headers=asked["headers"],
                json=asked.get("json"),
                content=asked.get("data"),
            )
            assert answer.status_code not in (500, 501, 504)
            role = 0 if name == "stranger" else Role[name]
            code = answer.json()["code"] if "problem" in answer.headers.get("content-type", "") else ""
            if role < entry.least:
                assert (answer.status_code, code) in ((401, "not_admitted"), (403, "role_too_low"))
            else:
                assert code not in ("not_admitted", "role_too_low")

    ask()


def test_the_board_is_still_there_after_all_that(flying: Gateway) -> None:
    assert flying.http.get("/status").json()["errors"].get("internal", 0) == 0

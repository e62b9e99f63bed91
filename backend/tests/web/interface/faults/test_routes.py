"""Faults over REST: read by everybody, ordered by owners alone, refused without the embedded simulator."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from epf_gcs.access.roles import Role
from tests.support.callers import person, strict_gateway
from tests.support.embedded import embedded_simulator
from tests.support.gateway import Gateway
from tests.support.ports import free_udp_port
from tests.support.waiting import eventually


@pytest.fixture(scope="module")
def gateway(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    with strict_gateway(tmp_path_factory.mktemp("faults") / "data") as running:
        yield running


def open_simulator(gateway: Gateway, port: int, station_port: int) -> None:
    with person(gateway, Role.owner, "Olga") as owner:
        link = {"receive_port": station_port, "send_host": "127.0.0.1", "send_port": port}
        owner.put("/links/simulator", json=link).raise_for_status()
        eventually(lambda: owner.get("/faults").json()["flown"] is not None, "the simulator takes orders")


def test_the_table_says_what_can_be_asked_for_and_what_it_takes(gateway: Gateway) -> None:
    with person(gateway, Role.viewer) as viewer:
        table = viewer.get("/faults").raise_for_status().json()
    assert table["flown"] is None
    found = {(one["place"], one["kind"]): one for one in table["choices"]}
    assert found["gyro", "drift"]["unit"] == "rad/s/s"
    assert found["engine", "out"]["usual_s"] is None
    assert found["line", "cut"]["usual_s"] == 2.0
    assert not {("gyro", "dropout"), ("line", "flipped"), ("board", "reset")} & found.keys()


@pytest.mark.parametrize("role", [Role.viewer, Role.operator])
def test_only_owners_let_something_go_wrong(gateway: Gateway, role: Role) -> None:
    with person(gateway, role) as other:
        for method, path, body in (
            ("POST", "/faults", {"place": "gyro", "kind": "bias"}),
            ("DELETE", "/faults", None),
            ("DELETE", "/faults/a", None),
            ("PUT", "/faults/wind", {"from_deg": 0, "speed_kt": 10}),
        ):
            answer = other.request(method, path, json=body)
            assert (answer.status_code, answer.json()["code"]) == (403, "role_too_low")


@pytest.mark.parametrize(
    ("body", "status", "code"),
    [
        ({"place": "gyro", "kind": "bias"}, 409, "faults_no_simulator"),
        ({"place": "gyro", "kind": "dropout"}, 422, "fault_not_carried"),
        ({"place": "gyro", "kind": "bias", "strength": 99}, 422, "fault_out_of_range"),
        ({"place": "tail", "kind": "off"}, 422, "invalid_request"),
        ({"place": "gyro", "kind": "bias", "length_s": 0}, 422, "invalid_request"),
    ],
)
def test_a_fault_that_cannot_be_is_one_sentence(
    gateway: Gateway, body: dict[str, object], status: int, code: str
) -> None:
    with person(gateway, Role.owner) as owner:
        answer = owner.post("/faults", json=body)
    assert (answer.status_code, answer.json()["code"]) == (status, code)


def test_an_owner_orders_faults_and_wind_and_every_viewer_sees_them(tmp_path: Path) -> None:
    station_port = free_udp_port()
    with strict_gateway(tmp_path / "data") as gateway, embedded_simulator(station_port) as port:
        open_simulator(gateway, port, station_port)
        with person(gateway, Role.owner, "Olga") as owner, person(gateway, Role.viewer, "Vera") as viewer:
            answer = owner.post("/faults", json={"place": "pitot", "kind": "bias", "strength": 8, "length_s": 600})
            assert answer.status_code == 201
            fault = answer.json()
            assert fault["ends_s"] - fault["begins_s"] == pytest.approx(600.0)
            assert viewer.get("/status").json()["simulator"]["faults"]["faults"] == [fault]
            wind = {"from_deg": 250.0, "speed_kt": 12.0, "turbulence": "light"}
            assert owner.put("/faults/wind", json=wind).raise_for_status().json()["wind"] == wind
            assert owner.delete(f"/faults/{fault['id']}").raise_for_status().json()["faults"] == []
            assert owner.delete(f"/faults/{fault['id']}").status_code == 404
            owner.post("/faults", json={"place": "gps", "kind": "jump", "start_s": 60}).raise_for_status()
            assert owner.delete("/faults").raise_for_status().json() == {"faults": [], "wind": wind}
            deeds = [one["what"] for one in owner.get("/access/log").json()["deeds"] if one["deed"] == "faults"]
            assert len(deeds) == 6

"""The board is held against the page of its own protocol, as `epf-lab conform` holds any board."""

from __future__ import annotations

from board_tests.line.conftest import Boards
from epf_gcs.lab.conformance import conform
from epf_gcs.lab.peer import wire
from tests.support.waiting import DEADLINE_S


def lacks(url: str, patience_s: float) -> dict[str, str]:
    line = wire(url)
    found = {one.name: one.lacks for one in conform(line, patience_s) if one.lacks is not None}
    line.close()
    return found


def test_the_board_lacks_nothing(boards: Boards) -> None:
    assert lacks(f"tcp://127.0.0.1:{boards('--tcp', '0').tcp_port}", DEADLINE_S) == {}


def test_a_board_like_the_deployed_ones_lacks_the_extensions_alone(boards: Boards) -> None:
    # Its silence is waited for: not as long as the answer of a busy board may take.
    found = lacks(f"tcp://127.0.0.1:{boards('--legacy', '--tcp', '0').tcp_port}", 5.0)
    assert set(found) == {"extensions: the capabilities are told, in version 1"}

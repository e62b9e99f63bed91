"""The lab's pytest plug-in: the fixture `lab`, which flies, and the option that says which board's laws fly.

def test_gando_in_a_crosswind(lab):
    flight = lab.fly("gando", wind_kt=15, wind_from_deg=250, seed=7)
    assert flight.waypoints_reached == 8
    flight.check(near_rms_m=60, altitude_rms_ft=20)
"""

from __future__ import annotations

import math
from collections.abc import Generator, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import pytest

from epf_gcs.lab.bounds import FIGURE, Bounds

if TYPE_CHECKING:
    from epf_gcs.codec.tables import Waypoint
    from epf_gcs.lab.faults import Asked
    from epf_gcs.lab.flight import Flight
    from epf_gcs.lab.watched import Watched, WatchedAircraft
    from epf_gcs.simulator.simulation import SimulationOptions

FOLDER: Final = "epf-lab-flights"
"""The data folder for the flights of failed tests, below pytest's root."""

# What flies is imported where it is used: pytest loads a plug-in in every run on a computer that has it.


class Lab:
    """Flies a board's laws in the simulator. `library`: the laws; None: those of this station's own board. `usual`:
    conditions of every flight that does not say otherwise."""

    def __init__(self, library: Path | None = None, **usual: Any) -> None:
        self.library = library
        self._usual = usual
        self.flights: list[Flight] = []

    def fly(
        self,
        route: str | Path | Sequence[Waypoint],
        *,
        gains: Mapping[str, float] | None = None,
        faults: Iterable[Asked] = (),
        longest_s: float = math.inf,
        **conditions: Any,
    ) -> Flight:
        """Fly a route by name (`gando`), from a plan file, or of waypoints. `gains`: by the board's names, as `k_roll`.
        `faults`: as `gyro.drift@60+30=0.002` (see `epf_gcs.lab.faults`). `longest_s`: it ends then at the latest.

        The conditions are those of `epf_gcs.lab.conditions.Conditions`, as `wind_kt=15, seed=7`. Raises LabError for a
        route, a gain, a condition or a fault that there is none of, and for a fault that was not there.
        """
        from epf_gcs.lab.flying import fly_wanted  # noqa: PLC0415 - see above

        flown = fly_wanted(route, {**self._usual, **conditions}, gains, self.library, faults, longest_s)
        self.flights.append(flown)
        return flown

    def watch(self, faults: Iterable[Asked] = (), **conditions: Any) -> Watched:
        """A board on the path of HIL, to be flown step by step. Raises LabError as `fly`."""
        from epf_gcs.lab.faults import read  # noqa: PLC0415 - see above
        from epf_gcs.lab.watched import Watched  # noqa: PLC0415

        return Watched(self._options(conditions), read(faults), self.library)

    def watch_aircraft(self, faults: Iterable[Asked] = (), **conditions: Any) -> WatchedAircraft:
        """The same in the loop of the real aircraft."""
        from epf_gcs.lab.faults import read  # noqa: PLC0415 - see above
        from epf_gcs.lab.watched import WatchedAircraft  # noqa: PLC0415

        return WatchedAircraft(self._options(conditions), read(faults), self.library)

    def _options(self, conditions: Mapping[str, Any]) -> SimulationOptions:
        from epf_gcs.lab.conditions import Conditions  # noqa: PLC0415 - see above

        return Conditions.of({**self._usual, **conditions}).options()


def pytest_addoption(parser: pytest.Parser) -> None:
    """The lab's options."""
    group = parser.getgroup("lab", "epf-lab: flights of a board's laws in the simulator")
    group.addoption("--laws", type=Path, help="the shared library with the board's laws; usual: this station's own")
    group.addoption("--seeds", type=int, default=3, help="how many seeds a suite flies where chance has a part")
    group.addoption("--figures", action="store_true", help="say each figure beside its bound, of every test")
    group.addoption("--aircraft", default=None, help="what they are flown in: rc (usual) or c172p")
    group.addoption(
        "--record",
        type=Path,
        metavar="FOLDER",
        help=f"a station's data folder, for the recordings and pages of all flights; usual: {FOLDER}, for failed tests",
    )


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """A test that takes a `lab_seed` is flown with each."""
    if "lab_seed" in metafunc.fixturenames:
        metafunc.parametrize("lab_seed", range(1, metafunc.config.getoption("--seeds") + 1))


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """The figures of all tests."""
    if not config.getoption("--figures"):
        return
    terminalreporter.section("figures")
    for outcome in ("passed", "failed"):
        for report in terminalreporter.getreports(outcome):
            for name, sentence in report.user_properties:
                if name == FIGURE:
                    terminalreporter.write_line(f"{outcome}  {report.nodeid.rpartition('::')[2]}: {sentence}")


@pytest.fixture
def bounds(request: pytest.FixtureRequest) -> Bounds:
    """Holds figures against their bounds, and keeps both."""
    return Bounds(lambda name, value: request.node.user_properties.append((name, value)))


@pytest.fixture(scope="session")
def lab(pytestconfig: pytest.Config) -> Lab:
    """Flies what the command line names."""
    aircraft = pytestconfig.getoption("--aircraft")
    return Lab(pytestconfig.getoption("--laws"), **({} if aircraft is None else {"aircraft": aircraft}))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Generator[None, Any, Any]:
    """Tell the figures of a test's flights in JUnit's file, and record those of a test that failed."""
    report = yield
    flown = getattr(item, "funcargs", {}).get("lab")
    if call.when == "call" and isinstance(flown, Lab):
        flights, flown.flights = flown.flights, []
        folder = item.config.getoption("--record")
        if report.failed or folder is not None:
            _record(item, report, flights, folder or item.config.rootpath / FOLDER)
        else:
            _tell(item, flights)
    return report


def _record(item: pytest.Item, report: pytest.TestReport, flights: Sequence[Flight], folder: Path) -> None:
    from epf_gcs.lab.errors import LabError  # noqa: PLC0415 - see above
    from epf_gcs.lab.keeping import keep  # noqa: PLC0415

    lines, links = [], []
    for flight in flights:
        lines.append(str(flight))
        try:
            kept = keep(flight, folder, item.name)
            links.append(kept.recorded.link)
            lines += kept.lines()
        except LabError as error:
            links.append("")
            lines.append(f"  not recorded: {error}")
    _tell(item, flights, links)
    if lines:
        report.sections.append(("flights of the lab", "\n".join(lines)))


def _tell(item: pytest.Item, flights: Sequence[Flight], links: Sequence[str] = ()) -> None:
    from epf_gcs.lab.flight import FIGURES  # noqa: PLC0415 - see above

    for number, flight in enumerate(flights):
        name = "flight" if len(flights) == 1 else f"flight{number + 1}"
        told = {"flight": str(flight), "seed": flight.conditions.seed}
        told |= {figure: read(flight) for figure, read in FIGURES.items()}
        told |= {f"{figure}_bound": bound for figure, bound in flight.bounds.items()}
        if links and links[number]:
            told["link"] = links[number]
        item.user_properties += [(f"{name}.{key}", value) for key, value in told.items()]

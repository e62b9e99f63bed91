"""A simulator's datagrams -> the samples that viewers see: its values by name, what the board is told, and raw rows.

What comes out depends on the datagrams and their times alone, so that a replay shows what was shown live.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final, NamedTuple, Protocol, cast

from epf_gcs.codec.messages_gen import XPLANE_ROWS
from epf_gcs.contract.base import SimulatorProfile, Values
from epf_gcs.vehicle.arrivals import Arrivals, KeptArrivals
from epf_gcs.vehicle.judges import Finding
from epf_gcs.vehicle.pace_judge import POSITION_ROW, SPEED_ROW, PaceJudge
from epf_gcs.vehicle.profile_judge import ATTITUDE_ROW, RATES_ROW, ProfileJudge
from epf_gcs.vehicle.simulator_motion import MOTION_ROWS, Jump, MotionState, SimulatorMotion
from epf_gcs.vehicle.unusable_value import UnusableValue
from epf_gcs.xplane.datagram import Eight, Record, parse
from epf_gcs.xplane.gather import Gatherer, GathererState
from epf_gcs.xplane.mapping import NEEDED_ROWS, XplaneInfo, row_meaning, unusable_values
from epf_gcs.xplane.whole import WholeFrames

# Hide a row not received for this long: 20 periods of the slowest simulator.
_ROW_AGE_S: Final = 1.0
# X-Plane has some 140 rows; ignore further row numbers, which no simulator sends.
_MOST_ROWS: Final = 256
_SHOW_EVERY_S: Final = 0.02
_RAW_EVERY_S: Final = 0.2
SIMULATOR_TOPICS: Final = frozenset({"simulator", "xplane_info", "xplane_rows"})
"""The topics that are made of the simulator's rows."""


class Samples(Protocol):
    """Where samples go: the telemetry of a vehicle."""

    def take(self, topic: str, t_s: float, values: Values, implausible: Iterable[str] = (), /) -> None:
        """Take a sample, heard at Unix time `t_s`."""


class Reading(NamedTuple):
    """One datagram: when it came (Unix s), its rows if they were parsed, and what it completes for the board."""

    t_s: float
    datagram: bytes
    records: list[Record] | None
    info: XplaneInfo | None


class SimulatorState(NamedTuple):
    """All that the next samples depend on; Unix times. The two rules as their `kept` gives them."""

    profile: SimulatorProfile
    shown_s: float
    raw_shown_s: float
    datagrams: int
    bytes_in: int
    gatherer: GathererState
    profile_judge: list[Any]
    pace_judge: list[Any]
    rows: dict[int, KeptArrivals]
    motion: MotionState


class SimulatorSamples:
    """`read` does only what the loop with the board waits for; `show` makes the samples, in the order of the line."""

    def __init__(self, telemetry: Samples, on_jump: Callable[[Jump], None] = lambda _: None) -> None:
        self._telemetry = telemetry
        self._profile: SimulatorProfile = "xp10"
        self._gatherer = Gatherer(self._profile)
        self._whole_frames = WholeFrames(self._profile)
        self._rows: dict[int, Arrivals] = {}
        self._begin_judging()
        self.motion = SimulatorMotion(on_jump)
        self._shown_s = 0.0
        self._raw_shown_s = 0.0
        self.datagrams = 0
        self.bytes_in = 0

    @property
    def arrivals(self) -> Mapping[int, Arrivals]:
        """Arrival statistics of each row, by row number; Unix times."""
        return self._rows

    @property
    def profile(self) -> SimulatorProfile:
        """Which generation of the simulator the rows are read as."""
        return self._profile

    def begin(self, profile: SimulatorProfile) -> None:
        """Another simulator: forget the earlier one's data."""
        self._profile = profile
        self._gatherer = Gatherer(profile)
        self._whole_frames = WholeFrames(profile)
        self._rows.clear()
        self._begin_judging()
        self.motion.forget()

    def end(self) -> None:
        """The simulator is closed: what its rows said of it does not hold for the next one."""
        self._begin_judging()

    @property
    def fitting_profile(self) -> SimulatorProfile | None:
        """The generation of the simulator that its rows are of; None while they have not said."""
        return self._profile_judge.fits

    @property
    def is_profile_wrong(self) -> bool:
        """Whether the rows are of another generation of the simulator than they are read as."""
        return self._profile_judge.is_wrong(self._profile)

    def look(self, now_s: float) -> list[Finding | None]:
        """What is wrong with the simulator at Unix time `now_s`, as its rows tell."""
        return [self._profile_judge.look(now_s, self._profile), self._pace_judge.look(now_s)]

    def unusable(self, now_s: float) -> list[UnusableValue]:
        """The values that command 50 needs, whose rows arrive, and that cannot be used."""
        return [UnusableValue(*one) for one in unusable_values(self._live(now_s), self._profile)]

    def rows(self, now_s: float) -> list[int]:
        """Numbers of the rows that arrive at Unix time `now_s`."""
        return sorted(self._live(now_s))

    def missing_rows(self, now_s: float) -> list[int]:
        """Numbers of the rows that command 50 needs and that do not arrive."""
        return sorted(NEEDED_ROWS - self._live(now_s).keys())

    def read(self, datagram: bytes, t_s: float) -> Reading | None:
        """What a datagram that came at Unix time `t_s` says; None if it is not one of X-Plane's."""
        info = self._whole_frames.read(datagram)
        if info is not None:
            return Reading(t_s, datagram, None, info)
        records = parse(datagram)
        if records is None:
            return None
        return Reading(t_s, datagram, records, self._gatherer.take(records, t_s))

    def show(self, reading: Reading) -> None:
        """Take a datagram that was read, and make samples if they are due. Call the telemetry's `flush` after."""
        t_s, datagram, records, info = reading
        self.datagrams += 1
        self.bytes_in += len(datagram)
        self._keep_rows(parse(datagram) or () if records is None else records, t_s)
        if info is None and t_s - self._shown_s < _SHOW_EVERY_S:
            return
        self._shown_s = t_s
        live = self._live(t_s)
        named: dict[str, float | None] = dict(_NO_VALUES)
        implausible: list[str] = []
        for row, values in live.items():
            meaning = row_meaning(row, values, self._profile)
            named.update(meaning.values)
            implausible += meaning.implausible
        self._telemetry.take("simulator", t_s, named, implausible)
        if info is not None:
            self._telemetry.take("xplane_info", t_s, info._asdict())
        if t_s - self._raw_shown_s >= _RAW_EVERY_S:
            self._raw_shown_s = t_s
            raw = {str(row): list(values) for row, values in sorted(live.items())}
            self._telemetry.take("xplane_rows", t_s, {"rows": raw})

    def kept(self) -> SimulatorState:
        """For `restore`, before anything else is shown."""
        return SimulatorState(
            profile=self._profile,
            shown_s=self._shown_s,
            raw_shown_s=self._raw_shown_s,
            datagrams=self.datagrams,
            bytes_in=self.bytes_in,
            gatherer=self._gatherer.kept(),
            profile_judge=self._profile_judge.kept(),
            pace_judge=self._pace_judge.kept(),
            rows={row: one.kept() for row, one in self._rows.items()},
            motion=self.motion.kept(),
        )

    def restore(self, state: SimulatorState) -> None:
        """Go on from a state that `kept` gave."""
        self.begin(state.profile)
        self.shown(state.shown_s, state.raw_shown_s)
        self.datagrams = state.datagrams
        self.bytes_in = state.bytes_in
        self._gatherer.restore(state.gatherer)
        self._profile_judge.restore(state.profile_judge)
        self._pace_judge.restore(state.pace_judge)
        for row, (count, times_s, values) in state.rows.items():
            self._rows[row] = Arrivals.restored(count, times_s, tuple(values))
        self.motion.restore(state.motion)

    @property
    def raw_shown_s(self) -> float:
        """When the raw rows were last shown."""
        return self._raw_shown_s

    def shown(self, shown_s: float, raw_shown_s: float) -> None:
        """Samples and raw rows were shown at these Unix times, by whoever reads many datagrams at once."""
        self._shown_s, self._raw_shown_s = shown_s, raw_shown_s

    def _begin_judging(self) -> None:
        self._profile_judge, self._pace_judge = ProfileJudge(), PaceJudge()
        self._judges: dict[int, ProfileJudge | PaceJudge] = {
            RATES_ROW: self._profile_judge,
            ATTITUDE_ROW: self._profile_judge,
            SPEED_ROW: self._pace_judge,
            POSITION_ROW: self._pace_judge,
        }

    def _keep_rows(self, records: Iterable[Record], t_s: float) -> None:
        for row, values in records:
            arrivals = self._rows.get(row)
            if arrivals is None:
                if len(self._rows) >= _MOST_ROWS:
                    continue
                arrivals = self._rows[row] = Arrivals()
            arrivals.heard(t_s, values)
            judge = self._judges.get(row)
            if judge is not None:
                judge.take(row, values, t_s)
            if row in MOTION_ROWS:
                self.motion.take(row, values, t_s, self._profile)

    def _live(self, now_s: float) -> dict[int, Eight]:
        oldest_s = now_s - _ROW_AGE_S
        return {row: one.values for row, one in self._rows.items() if (one.last_s or 0.0) >= oldest_s}


_NO_VALUES: Final[dict[str, None]] = {
    name: None
    for row in XPLANE_ROWS["xp10"].values()
    for name in row_meaning(row.id, cast(Eight, (0.0,) * 8), "xp10").values
}

"""A vehicle can be made twice: two that fly at the same time, at different times of day, know nothing of each other."""

from __future__ import annotations

import json

import msgspec

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.frame import Frame
from epf_gcs.codec.values import Meaning
from epf_gcs.error_log import ErrorLog
from epf_gcs.vehicle.vehicle import Vehicle, VehicleState
from epf_gcs.xplane.datagram import Record, build
from tests.codec.streams import damage, mixed_frames
from tests.support.outlet import KeptOutlet


def as_json(state: VehicleState) -> str:
    """As a key frame holds it."""
    return json.dumps(msgspec.to_builtins(state))


def from_json(text: str) -> VehicleState:
    return msgspec.convert(json.loads(text), VehicleState, str_keys=True)


class SetClock:
    """The time that a test says."""

    def __init__(self, at_s: float) -> None:
        self.at_s = at_s

    def now_s(self) -> float:
        return self.at_s

    def steady_s(self) -> float:
        return self.at_s


class Sink:
    """A line that takes everything."""

    baud = 115200
    backlog = 0

    def write(self, data: bytes) -> bool:
        return bool(data)


class Alone:
    """Has the line for itself."""

    def on_bytes(self, data: bytes) -> None:
        del data

    def on_line_released(self) -> bytes:
        return b""


class Flown:
    """A vehicle with a clock and an outlet of its own."""

    def __init__(self, begin_s: float, *, is_lazy: bool = False) -> None:
        self.clock = SetClock(begin_s)
        self.outlet = KeptOutlet()
        self.outlet.is_lazy = is_lazy
        self.vehicle = Vehicle(self.clock, self.outlet, ErrorLog(), lambda _: 0.02)

    def hear(self, roll_deg: float) -> None:
        self.clock.at_s += 0.02
        self.vehicle.board.on_bytes(encode_telemetry("ahrs", 90.0, 0.0, roll_deg))

    def rolls(self) -> list[tuple[float, float]]:
        return [(round(t_s, 3), values["roll_deg"]) for topic, t_s, values in self.outlet.samples if topic == "ahrs"]


def test_two_vehicles_do_not_disturb_each_other() -> None:
    live, replayed = Flown(1_000_000.0), Flown(500.0)
    for step in range(50):
        live.hear(step)
        replayed.hear(-step)
        replayed.vehicle.board.on_bytes(b"\x00noise\x00")
    assert live.rolls() == [(round(1_000_000.0 + 0.02 * (step + 1), 3), step) for step in range(50)]
    assert [roll for _, roll in replayed.rolls()] == [-step for step in range(50)]
    assert live.vehicle.board.damage["noise"] == 0
    assert replayed.vehicle.board.damage["noise"] > 0
    assert live.vehicle.telemetry.is_live("ahrs")
    live.clock.at_s += 60.0
    assert not live.vehicle.telemetry.is_live("ahrs")
    assert replayed.vehicle.telemetry.is_live("ahrs"), "its own clock says that no time has passed"


def test_the_same_bytes_at_the_same_times_say_the_same() -> None:
    first, second = Flown(7.0), Flown(7.0)
    for step in range(20):
        first.hear(step)
    for step in range(20):
        second.hear(step)
    assert first.outlet.samples == second.outlet.samples


def test_frames_that_wait_are_there_for_whoever_looks() -> None:
    flown = Flown(7.0, is_lazy=True)
    for step in range(5):
        flown.hear(step)
    assert flown.rolls() == [], "nobody looked"
    assert flown.vehicle.board.frames_received == 5, "but they are counted"
    newest = flown.vehicle.telemetry.newest("ahrs")
    assert newest is not None
    assert newest["roll_deg"] == 4.0
    assert flown.rolls() == [(round(7.0 + 0.02 * (step + 1), 3), step) for step in range(5)]


def test_a_vehicle_whose_frames_wait_says_the_same_in_the_end() -> None:
    stream = damage(mixed_frames(600, seed=5), 0.002, seed=6).data
    at_once, lazy = Flown(7.0), Flown(7.0, is_lazy=True)
    for flown in (at_once, lazy):
        for place in range(0, len(stream), 37):
            flown.clock.at_s += 0.003
            flown.vehicle.board.on_bytes(stream[place : place + 37])
        flown.vehicle.board.tick()
    assert len(lazy.outlet.samples) > 500
    assert lazy.outlet.samples == at_once.outlet.samples
    assert lazy.outlet.events == at_once.outlet.events
    assert lazy.vehicle.kept() == at_once.vehicle.kept()
    assert lazy.vehicle.telemetry.summary() == at_once.vehicle.telemetry.summary()


def test_frames_that_were_read_together_wait_for_the_last_of_them() -> None:
    flown = Flown(7.0)
    with flown.vehicle.board.together():
        flown.hear(1.0)
        flown.hear(2.0)
        assert flown.rolls() == []
    assert flown.rolls() == [(7.02, 1.0), (7.04, 2.0)]
    flown.hear(3.0)
    assert len(flown.rolls()) == 3, "afterwards none waits"


def test_a_line_of_text_among_frames_that_were_read_together_does_not_overtake_them() -> None:
    flown = Flown(7.0)
    with flown.vehicle.board.together():
        flown.hear(1.0)
        flown.vehicle.board.on_bytes(b"board says this\r\n")
        assert [kind for kind, _ in flown.outlet.events] == ["console"]
        assert flown.rolls() == [(7.02, 1.0)], "what came before the text is out before it"


def test_the_bytes_of_a_board_may_wait_only_while_no_answer_of_it_is_awaited() -> None:
    flown = Flown(7.0)
    board = flown.vehicle.board
    assert not board.may_wait(), "nobody has opened it"
    board.attach(Sink())
    board.on_bytes(encode_telemetry("heartbeat", *([1] * 10), 3, 0))
    flown.clock.at_s += 1.0
    board.tick()
    assert board.may_wait()
    with board.listening(lambda _frame, _meant: None):
        assert not board.may_wait()
    assert board.may_wait()
    board.acquire_line(Alone())
    assert not board.may_wait()


def test_samples_of_the_simulator_do_not_overtake_frames_that_wait() -> None:
    flown = Flown(7.0, is_lazy=True)
    flown.hear(1.0)
    flown.vehicle.telemetry.take("simulator", flown.clock.at_s, {"n": 1})
    assert [topic for topic, _, _ in flown.outlet.samples] == ["ahrs", "simulator"]


def test_who_listens_gets_what_comes_from_then_on_and_at_once() -> None:
    flown = Flown(7.0, is_lazy=True)
    heard: list[object] = []

    def listen(frame: Frame, meant: Meaning) -> None:
        heard.append(meant.values["roll_deg"])

    flown.hear(1.0)
    with flown.vehicle.board.listening(listen):
        assert heard == [], "a frame from before would prove a command that was not sent yet"
        flown.hear(2.0)
        assert heard == [2.0]
    flown.hear(3.0)
    flown.vehicle.board.tick()
    assert heard == [2.0]


def test_who_listens_does_not_get_what_the_line_had_before() -> None:
    flown = Flown(7.0)
    board, heard = flown.vehicle.board, []
    board.attach(Sink(), deliver=lambda: flown.hear(1.0))
    with board.listening(lambda _frame, meant: heard.append(meant.values["roll_deg"])):
        assert flown.rolls() == [(7.02, 1.0)], "it was delivered before"
        flown.hear(2.0)
    assert heard == [2.0]


def test_the_hil_path_reads_the_newest_heartbeat_and_leaves_the_rest_waiting() -> None:
    flown = Flown(7.0, is_lazy=True)
    flown.hear(1.0)
    for source_joystick in (2, 0):
        flown.vehicle.board.on_bytes(encode_telemetry("heartbeat", *([1] * 10), source_joystick, 0))
    flown.hear(2.0)
    flown.vehicle.board.on_bytes(encode_telemetry("statistics", 1, 1))
    newest = flown.vehicle.telemetry.peek("heartbeat")
    assert newest is not None
    assert newest["source_joystick"] is False
    assert flown.outlet.samples == []
    assert flown.vehicle.telemetry.peek("gps") is None


def test_an_acknowledgement_is_counted_as_it_comes() -> None:
    flown = Flown(7.0, is_lazy=True)
    counted: list[object] = []
    flown.vehicle.board.listen("acknowledgement", lambda _, meant: counted.append(meant.values["command_type"]))
    flown.vehicle.board.on_bytes(encode_telemetry("acknowledgement", 50, 0))
    assert counted == [50]


ROWS = (3, 4, 8, 16, 17, 18, 20, 25)


def fly_on(flown: Flown, pieces: list[bytes], step: int) -> None:
    """Bytes of the board, each piece with one row of the simulator beside it, whose rows are in no usual order."""
    for place, piece in enumerate(pieces, step):
        flown.clock.at_s += 0.01
        flown.vehicle.board.on_bytes(piece)
        value = 2.0 if place % 50 == 0 else place % 90 / 100.0
        row = Record(ROWS[-place % len(ROWS)], (value, 1e9 if place % 61 == 0 else value, *[value] * 6))
        reading = flown.vehicle.simulator.read(build([row]), flown.clock.now_s())
        assert reading is not None
        flown.vehicle.simulator.show(reading)
        if place % 20 == 0:
            flown.vehicle.board.tick()


def everything(flown: Flown) -> tuple[object, ...]:
    vehicle = flown.vehicle
    vehicle.telemetry.catch_up()
    return (
        vehicle.kept(),
        vehicle.telemetry.summary(),
        vehicle.telemetry.snapshot(),
        vehicle.board.is_open,
        vehicle.board.frames_damaged,
        vehicle.board.hears_only_rubbish,
        vehicle.board.missing_bytes(),
        vehicle.simulator.missing_rows(flown.clock.now_s()),
    )


def test_a_vehicle_that_goes_on_from_what_was_kept_says_the_same_as_one_that_flew_through() -> None:
    frames = mixed_frames(120, seed=3)
    frames[40:40] = [b"\rstatus: well\r\n", b"\x81\x93", frames[0][:9]]
    stream = damage(frames, 0.004, seed=4).data
    pieces = [stream[place : place + 23] for place in range(0, len(stream), 23)]
    through, kept, sent = Flown(7.0), [], []
    through.vehicle.board.attach(Sink())
    through.vehicle.simulator.begin("xp12")
    for place in range(0, len(pieces), 31):
        kept.append((place, through.clock.at_s, as_json(through.vehicle.kept())))
        sent.append((len(through.outlet.samples), len(through.outlet.events)))
        fly_on(through, pieces[place : place + 31], place)
    expected = everything(through)
    assert through.vehicle.board.session.is_open
    for (place, at_s, state), (samples, events) in zip(kept, sent, strict=True):
        again = Flown(at_s)
        again.vehicle.board.attach(Sink())
        again.vehicle.restore(from_json(state))
        assert (again.outlet.samples, again.outlet.events) == ([], [])
        fly_on(again, pieces[place:], place)
        assert again.outlet.samples == through.outlet.samples[samples:]
        assert again.outlet.events == through.outlet.events[events:]
        assert everything(again) == expected


def test_frames_that_waited_when_another_moment_was_chosen_are_of_no_moment_any_more() -> None:
    other, flown = Flown(7.0), Flown(7.0, is_lazy=True)
    other.hear(1.0)
    flown.hear(2.0)
    flown.vehicle.restore(other.vehicle.kept())
    newest = flown.vehicle.telemetry.newest("ahrs")
    assert newest is not None
    assert newest["roll_deg"] == 1.0
    assert flown.outlet.samples == []


def test_text_that_waited_for_its_end_when_the_state_was_kept_is_shown_after_the_same_silence() -> None:
    flown, again = Flown(7.0), Flown(7.0)
    flown.vehicle.board.on_bytes(b"prompt> ")
    flown.vehicle.board.tick()
    assert flown.outlet.events == []
    again.vehicle.restore(from_json(as_json(flown.vehicle.kept())))
    again.vehicle.board.tick()
    assert again.outlet.events == [("console", {"direction": "received", "text": "prompt>", "client": None})]

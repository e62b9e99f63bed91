"""Bugs planted in copies of the laws and of the line's code, and whether the lab's suites catch them.

    python -m bench.planted [NUMBER...]    each bug, or those of these numbers
    python -m bench.planted clean SEEDS    the laws as they are, flown with so many seeds

A bug is one change of one source; the file is compiled with it in a folder that is thrown away, and linked with the
objects of `make -C firmware flight-lib`. A bug is caught where a suite fails; the first test that does is told.
"""

# ruff: noqa: E501 - a bug is a line of the table
from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Final, NamedTuple

FIRMWARE: Final = Path(__file__).parents[2] / "firmware"
SUITES: Final = Path(__file__).parents[1] / "src" / "epf_gcs" / "lab" / "suites"
# The quick ones first: the first failure ends the run.
_ORDER: Final = ("line", "failsafes", "bumpless", "steps", "link", "routes", "wind", "faults")


class Bug(NamedTuple):
    """What is changed, and what that is. `by`: the suite that is flown first, which is likely to catch it."""

    by: str
    says: str
    file: str
    old: str
    new: str


BUGS: Final = (
    Bug("bumpless", "sign: the yaw damper pushes", "control/fly_by_wire.c", "command->rudder - input->r_rad_s", "command->rudder + input->r_rad_s"),
    Bug("steps", "sign: a climb asks for a lower nose", "control/autopilot.c", "target_ft - (input->altitude_ft +", "target_ft - (input->altitude_ft -"),
    Bug("bumpless", "unit: the pitch error stays in degrees", "control/autopilot.c", "angle_to_rad(pitch_d_deg - input->pitch_deg)", "(pitch_d_deg - input->pitch_deg)"),
    Bug("routes", "unit: the capture radius takes knots for m/s", "navigation/plan.c", "speed_kt * M_S_PER_KT", "speed_kt"),
    Bug("wind", "unit: the track is taken for a magnetic one", "flight/control_loop.c", ".track_deg = track_deg,", ".track_deg = track_deg + 6.0F,"),
    Bug("steps", "saturation: the bank is not limited to 30 deg", "control/autopilot.c", "roll_limit_deg = 30.0F", "roll_limit_deg = 50.0F"),
    Bug("steps", "saturation: the aileron command is cut too early", "control/autopilot.c", "aileron_limit = 0.7F", "aileron_limit = 0.04F"),
    Bug("wind", "integrator: the altitude's is missing", "control/autopilot.c", "* error_ft * dt_s;", "* error_ft * 0.0F * dt_s;"),
    Bug("steps", "integrator: the altitude's window is ten times as wide", "control/autopilot.c", "window_ft = 100.0F", "window_ft = 1000.0F"),
    Bug("failsafes", "integrator: the trim winds on in a pause", "flight/hil_loop.c", "return 0.0F;\n    }\n    if (hil->period_s > 0.0F)", "return 0.02F;\n    }\n    if (hil->period_s > 0.0F)"),
    Bug("steps", "integrator: a step takes 20 ms, whatever passed", "flight/hil_loop.c", "limit_to((float)elapsed_ms / 1000.0F, step_minimum_s, step_maximum_s)", "0.02F"),
    Bug("routes", "capture: far outside the radius", "navigation/plan.c", "guidance->distance_m >= plan_capture_radius_m(speed_kt)", "guidance->distance_m >= 2.0F * plan_capture_radius_m(speed_kt)"),
    Bug("line", "capture: a waypoint is left out", "navigation/plan.c", "fly_to(plan, plan->current + 1);", "fly_to(plan, plan->current + 2 < plan->count ? plan->current + 2 : plan->current + 1);"),
    Bug("routes", "wrap: the course error goes the long way round", "control/autopilot.c", "angle_wrap_180(course_deg - input->track_deg)", "(course_deg - input->track_deg)"),
    Bug("failsafes", "timeout: the simulator may be silent for 5 s", "flight/failsafe.c", '"simulator silent", 500', '"simulator silent", 5000'),
    Bug("failsafes", "timeout: unknown rates are waited for ten times as long", "flight/failsafe.c", '"rates unknown", 200', '"rates unknown", 2000'),
    Bug("failsafes", "stale stick: a silent receiver's stick goes on", "flight/failsafe.c", '"receiver silent", 500, failsafe_flies_on, failsafe_lets_stick_go', '"receiver silent", 500, failsafe_flies_on, failsafe_flies_on'),
    Bug("failsafes", "failsafe: without altitude the autopilot flies by 0", "flight/failsafe.c", "failsafe_keeps_altitude, failsafe_flies_on}", "failsafe_flies_on, failsafe_flies_on}"),
    Bug("failsafes", "failsafe: without attitude the autopilot flies on", "flight/failsafe.c", '"attitude unknown", 200, failsafe_neutral_surfaces', '"attitude unknown", 200, failsafe_flies_on'),
    Bug("bumpless", "bump: nothing fades at a change of hands", "flight/control_loop.c", "    if (changed_hands)", "    if (changed_hands && false)"),
    Bug("bumpless", "bump: the throttle begins anew with the autopilot", "control/autopilot.c", "state->throttle = limit_to(throttle, 0.0F, 1.0F);", "state->throttle = 0.0F;"),
    Bug("line", "endianness: the type is read in the other order", "comms/frame.c", "const uint32_t type = protocol_get_u32(at + type_offset);", "const uint32_t type = __builtin_bswap32(protocol_get_u32(at + type_offset));"),
    Bug("line", "damage: the checksum is not looked at", "comms/frame.c", "if (sum_words(at + type_offset, 4 + size + 4) != 0)", "if (false)"),
    Bug("line", "lost frame: what follows a false header is skipped", "comms/frame.c", "decoder->start += header_bytes;\n}", "decoder->start = decoder->end;\n}"),
    Bug("line", "lost frame: each 50th command 50 is not answered", "flight/board_command_original.c", "    report_hil_surfaces(&board->line, &board->hil.loop.surfaces);\n", "    if (board->hil.accepted % 50U != 0U)\n    {\n        report_hil_surfaces(&board->line, &board->hil.loop.surfaces);\n    }\n"),
)  # fmt: skip


def build(bug: Bug, folder: Path) -> Path:
    """The laws with it, in `folder`. Raises SystemExit where the change no longer fits the source."""
    source = FIRMWARE / "src" / bug.file
    text = source.read_text(encoding="utf-8")
    if text.count(bug.old) != 1:
        raise SystemExit(f"{bug.says}: {bug.file} holds {bug.old!r} {text.count(bug.old)} times")
    changed = folder / source.name
    changed.write_text(text.replace(bug.old, bug.new), encoding="utf-8")
    mine = folder / "changed.o"
    flags = ["-std=c11", "-O2", "-ffp-contract=off", "-fPIC", "-w"]
    _run(["cc", *flags, f"-I{FIRMWARE / 'src'}", "-c", str(changed), "-o", str(mine)])
    objects = FIRMWARE / "build" / "library"
    left_out = objects / "src" / Path(bug.file).with_suffix(".o")
    others = [one for one in objects.rglob("*.o") if one != left_out and "tests" not in one.parts]
    library = folder / "libepf-flight.so"
    _run(["cc", "-shared", "-o", str(library), str(mine), *map(str, others), "-lm"])
    return library


def caught(library: Path, first: str, seeds: int = 1) -> str | None:
    """The first test that fails, with its figure; None: none did."""
    files = [f"test_{name}.py" for name in (first, *(name for name in _ORDER if name != first))]
    options = [
        "-n0",
        "-x",
        "-q",
        "-c",
        "/dev/null",
        "--rootdir",
        ".",
        "--import-mode=importlib",
        "-p",
        "no:cacheprovider",
    ]
    words = [*options, f"--laws={library}", f"--seeds={seeds}", "--tb=line", *files]
    ended = subprocess.run(
        [sys.executable, "-m", "pytest", *words], cwd=SUITES, capture_output=True, text=True, check=False
    )
    if ended.returncode == 0:
        return None
    lines = ended.stdout.splitlines()
    said = [line for line in lines if line.startswith(("FAILED", "ERROR", "E  ")) or "Error: " in line]
    return " | ".join(line.strip()[-160:] for line in said[:2]) or f"pytest ended with {ended.returncode}: {lines[-3:]}"


def clean(seeds: int) -> str | None:
    """The same for the laws as they are."""
    return caught(FIRMWARE / "build" / "posix" / "libepf-flight.so", _ORDER[0], seeds)


def table(numbers: Sequence[int]) -> Iterator[tuple[int, Bug, str | None]]:
    """Each bug with what caught it."""
    for number in numbers:
        with tempfile.TemporaryDirectory() as folder:
            yield number, BUGS[number], caught(build(BUGS[number], Path(folder)), BUGS[number].by)


def _run(words: list[str]) -> None:
    subprocess.run(words, check=True)


def main() -> None:
    """Say how many were caught."""
    words = sys.argv[1:]
    if words[:1] == ["clean"]:
        print(f"clean laws, {words[1]} seeds: {clean(int(words[1])) or 'no alarm'}")
        return
    numbers = [int(word) for word in words] or list(range(len(BUGS)))
    count = 0
    for number, bug, found in table(numbers):
        count += found is not None
        print(f"{number:2}  {'caught' if found else 'MISSED'}  {bug.says}  <- {found}", flush=True)
    print(f"{count} of {len(numbers)} planted bugs were caught")


if __name__ == "__main__":
    main()

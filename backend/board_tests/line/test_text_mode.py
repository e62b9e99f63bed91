"""The shell of text mode."""

from collections.abc import Callable

from board_tests.line.station import VERSION, Station


def test_the_help_lists_every_command_that_the_other_answers_name(text: Station) -> None:
    listed = "\n".join(text.lines("help"))
    for words in ("help", "status", "version", "param [name [value]]", "param store", "hil load <route>", "stream list",
                  "rc auto", "tasks", "servos", "reset"):  # fmt: skip
        assert words in listed


def test_a_board_in_text_mode_says_nothing_by_itself(text: Station) -> None:
    text.line("stream all on")
    text.received.clear()
    for _ in range(3):
        assert "uptime" in text.table("status")
    assert text.frames == []


def test_the_version_is_one_line(text: Station) -> None:
    text.send(b"version\n")
    text.wait(lambda: text.received.endswith(b"\n"))
    assert bytes(text.received) == f"\r{VERSION}\n".encode()


def test_the_status_tells_modes_and_counters(text: Station) -> None:
    status = text.table("status")
    assert status["extensions"] == "yes"
    assert status["card"] == "none"
    assert status["hil plan"] == "none"
    assert status["frames received"] == "0"
    assert status["autopilot"] == "off"


def test_the_tasks_are_those_of_the_deployed_board_and_three_above_them(text: Station) -> None:
    priorities = {line.split()[0]: int(line.split()[2]) for line in text.lines("tasks")}
    talking = ("ttyTask", "qParamTask", "qServosTask", "qFMSTask", "cardTask")
    assert set(priorities) == {"watchTask", "sensorTask", "controlTask", "UartRxTask", "UartTxTask", *talking}
    assert max(priorities[name] for name in talking) < min(
        priority for name, priority in priorities.items() if name not in talking
    )


def test_unknown_text_is_answered_by_one_clear_line(text: Station) -> None:
    assert text.line("fly me to the moon") == "unknown: fly (try `help`)"
    assert text.line("hil fly") == "unknown: fly (try `help`)"
    assert text.line("rate param") == "usage: rate param|fms|servos <ms>"


def test_a_line_that_is_too_long_is_refused_and_the_next_one_works(text: Station) -> None:
    assert text.line("param " + "x" * 200).startswith("too long")
    assert text.line("param k_pitch").startswith("k_pitch")


def test_noise_on_the_line_gets_no_answer(text: Station) -> None:
    text.send(b"\xff\x00\xaanoise\r\n" + bytes(range(128, 256)) + b"\n\n\r\n")
    assert text.lines("hil next") == ["refused: not possible in the present state (see `status`)"]


def test_frames_in_text_mode_get_no_answer(text: Station) -> None:
    text.command("ahrs_on")
    text.command("servo_out", 1, 0.5)
    text.command("xplane_info", *([0.25] * 15))
    assert len(text.lines("param k_pitch")) == 1
    assert text.frames == []


def test_a_typing_error_can_be_taken_back(text: Station) -> None:
    text.send(b"versjo\b\x7fion\n")
    text.wait(lambda: f"\r{VERSION}\n" in text.text)


def test_words_may_be_apart_and_in_capitals(text: Station) -> None:
    assert text.line("  HIL \t load   GANDO ") == "ok"
    assert "Gando" in "\n".join(text.lines("hil"))


def test_the_station_s_raw_line_loads_a_route(text: Station) -> None:
    # The old station's "send" field, as captured.
    text.send(bytes.fromhex("68696c206c6f61642067616e646f0a"))
    text.wait(lambda: "\rok\n" in text.text)
    plan = text.lines("hil")
    assert sum(" ft " in line for line in plan) == 8
    assert text.line("hil next") == "ok"
    assert [line[:5].split() for line in text.lines("hil") if line.startswith(">")] == [[">", "1"]]
    assert text.line("hil prev") == "ok"


def test_every_route_can_be_loaded_by_its_name(text: Station) -> None:
    for name, title, waypoints in (("gando", "Gando", 8), ("isla", "Ruta Isla", 20), ("ruta_isla", "Ruta Isla", 20),
                                   ("alternativa", "Alternativa", 11), ("vuelo", "Vuelo", 10)):  # fmt: skip
        assert text.line(f"hil load {name}") == "ok"
        plan = text.lines("hil")
        assert any(line.startswith("plan ") and line.endswith(title) for line in plan)
        assert sum(" ft " in line for line in plan) == waypoints
    assert text.line("hil load nowhere") == (
        "refused: no route has that name; there are gando ruta_isla alternativa vuelo"
    )


def test_a_parameter_is_shown_set_and_kept_inside_of_its_range(text: Station) -> None:
    assert len(text.lines("param")) == 17
    assert text.line("param k_pitch").split()[:2] == ["k_pitch", "2"]
    assert text.line("param K_PITCH 2.5").split()[:2] == ["k_pitch", "2.5"]
    assert text.line("param k_pitch 100").startswith("refused")
    assert text.line("param k_pitch two").startswith("refused")
    assert text.line("param k_div_velocidad 700.5").startswith("refused")
    assert text.line("param k_nothing").startswith("refused")
    assert text.line("param k_pitch").split()[:2] == ["k_pitch", "2.5"]


def test_streams_and_their_periods_are_set_for_binary_mode(text: Station) -> None:
    assert text.line("stream ahrs on") == "ok"
    assert text.line("rate servos 50") == "ok"
    listed = text.table("stream list")
    assert (listed["ahrs"], listed["gps"], listed["heartbeat"]) == ("on", "off", "on")
    assert listed["servos task"] == "50 ms"
    assert text.line("stream heartbeat off").startswith("refused")
    assert text.line("stream nothing on").startswith("refused")
    assert text.line("stream ahrs maybe").startswith("refused")
    assert text.line("rate fms 20").startswith("refused")
    text.open_binary()
    text.next("ahrs")


def test_the_transmitter_s_switches_show_in_the_heartbeat(text: Station) -> None:
    assert text.line("rc auto on") == "ok"
    assert text.line("rc trim on") == "ok"
    text.wait(lambda: any("4: 1 " in line and "5: 1 " in line for line in text.lines("rc")))
    text.open_binary()
    flags = text.heartbeat()
    # With the RC transmitter as source its switch rules the simulated aircraft too.
    assert (flags["autopilot"], flags["auto_switch"], flags["autotrim"]) == (1, 1, 1)
    assert (flags["autopilot_hil"], flags["autotrim_hil"]) == (1, 1)


def test_a_servo_is_moved_and_shown(text: Station) -> None:
    assert text.line("servo 7 -0.25") == "ok"
    assert any("7: -0.25" in line for line in text.lines("servos"))
    assert text.line("servo 20 0").startswith("refused")
    assert text.line("servo 7 1.5").startswith("refused")


def test_the_autopilot_of_the_simulated_aircraft_needs_the_joystick_as_source(text: Station) -> None:
    assert text.line("hil autopilot on").startswith("refused")
    assert text.line("hil source joystick") == "ok"
    assert text.line("hil autopilot on") == "ok"
    assert text.table("hil")["autopilot"] == "on"


def test_a_reset_forgets_everything_that_was_set(text: Station) -> None:
    text.line("hil load gando")
    text.line("param k_pitch 3")
    text.send(b"reset\n")
    text.wait(lambda: "\rok\n" in text.text)
    assert text.line("param k_pitch").split()[1] == "2"
    assert text.table("hil")["plan"] == "none"


def test_without_a_card_nothing_is_stored(text: Station) -> None:
    assert text.line("param store") == "failed: the card is missing or cannot be written"
    assert text.line("param load").startswith("failed")


def test_a_deployed_board_has_the_shell_too(plug: Callable[..., Station]) -> None:
    station = plug("--legacy")
    assert station.table("status")["extensions"] == "none (legacy)"

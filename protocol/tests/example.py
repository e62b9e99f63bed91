"""A ten-line wire of everything that the emitters know, for tests."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from generator.load import parse
from generator.model import Definition

PROTOCOL = Path(__file__).resolve().parent.parent
RULES: dict[str, Any] = json.loads((PROTOCOL / "definition.schema.json").read_text("utf-8"))

TEXTS = {
    "telemetry": """
[frame]
to_pc_header = "0D 51 54 2C"
to_board_header = "23 51 54 2C"
end = "0D 0A 0D 0A"
to_pc_type_bit = 31
forbidden_type_bits = [28, 29, 30]
open_binary_mode = "#QT\\n"
source = "test"
[[message]]
name = "heartbeat"
id = 0
size = 4
doc = "Flags."
source = "test"
fields = [
  { name = "armed", type = "i8", encoding = "flag", doc = "Is armed." },
  { name = "modes", type = "i8", encoding = "bits", range = [0, 3], doc = "Two.", bits = [
    { name = "auto", bit = 0, doc = "Flies itself." }, { name = "stick", bit = 1, doc = "By stick." } ] },
  { name = "count", type = "i16", unit = "1", range = [0, 9], absent = -1, sign = "none", doc = "Counts." },
]
[[message]]
name = "attitude"
id = 1
size = 16
doc = "Attitude."
source = "test"
absent = "nan"
fields = [
  { name = "roll", type = "f32", unit = "deg", range = [-180.0, 180.0], sign = "right wing down", doc = "Bank." },
  { name = "servo", type = "f32", count = 2, unit = "1", range = [-1.0, 1.0], sign = "up", doc = "Servo." },
  { name = "digits", type = "i32", encoding = "ascii_digits", unit = "1", range = [0, 99], sign = "none", doc = "2." },
]
[[message]]
name = "gains"
id = 2
size = 8
doc = "All gains."
source = "test"
fields_of = "parameters"
[[message]]
name = "place"
id = 0x100
size = 120
extension = true
topic = false
doc = "A place and its name."
source = "test"
fields = [
  { name = "latitude", type = "f64", unit = "deg", range = [-90.0, 90.0], sign = "north", doc = "Where." },
  { name = "title", type = "char16", encoding = "text", doc = "Name." },
  { name = "country", type = "char32", encoding = "text", doc = "Where it is." },
  { name = "note", type = "char64", encoding = "text", doc = "More of it." },
]
""",
    "commands": """
unused_ids = [7]
[[command]]
name = "stop"
id = 1
doc = "Stop."
confirm = { by = "heartbeat", armed = false }
[[command]]
name = "mode"
id = 2
size = 4
doc = "Choose the mode."
confirm = { by = "heartbeat", stick = "argument" }
fields = [
  {name="mode", type="i32", unit="1", range=[0, 1], sign="none", doc="Mode.", values={auto=0, stick=1}},
]
[[command]]
name = "pace"
id = 4
size = 4
doc = "Set the pace."
confirm = { by = "none" }
fields = [ { name="period", type="i32", unit="ms", range=[20, 900], default=50, sign="none", doc="Pace." } ]
[[command]]
name = "hil_load_home"
id = 3
doc = "Load the route."
confirm = { by = "none" }
""",
    "parameters": """
source = "test"
[[parameter]]
name = "k_roll"
group = "heading"
set_id = 60
type = "f32"
default = 2.0
range = [0.0, 99.99]
step = 0.1
doc = "Gain."
[[parameter]]
name = "k_time"
group = "speed"
set_id = 61
type = "i32"
default = 700
range = [10, 10000]
step = 10
doc = "Time."
""",
    "xplane": """
[datagram]
magic = "DATA"
tag_from_simulator = 0x40
tag_to_simulator = 0
values_per_row = 8
no_value = -999.0
receive_port = 49003
send_port = 49000
profiles = ["old", "new"]
source = "test"
[[row]]
id = 16
name = "rates"
doc = "Rates."
values = [ { index = 0, name = "q", unit = "rad/s", range = [-40.0, 40.0], sign = "nose up", doc = "Pitch rate." } ]
[row.profiles]
new = [ { index = 1, name = "q", unit = "deg/s", range = [-2300.0, 2300.0], sign = "nose up", doc = "Pitch rate." } ]
""",
    "routes": """
source = "test"
[[route]]
name = "home"
title = "Home"
plan_name = 0
load_id = 3
loop = true
doc = "There and back."
waypoints = [ [27.9319, -15.3866, 250.0, 50.0], [27.95, -15.37, 700.0, 55.0] ]
""",
}


def definition(**changed: tuple[str, str]) -> Definition:
    """The example, with one replacement in each named file."""
    texts = dict(TEXTS)
    for name, (old, new) in changed.items():
        assert old in texts[name]
        texts[name] = texts[name].replace(old, new, 1)
    return parse(texts, RULES)

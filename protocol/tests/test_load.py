"""What the definition files become, and what they may not say."""

from __future__ import annotations

import pytest

from generator.load import load, suffixed
from generator.model import Definition, DefinitionError, Message
from tests.example import PROTOCOL, definition


def _message(model: Definition, name: str) -> Message:
    return next(message for message in (*model.messages, *model.commands) if message.name == name)


def test_a_quantity_is_spelled_with_its_unit() -> None:
    assert suffixed("roll", "deg") == "roll_deg"
    assert suffixed("accx", "m/s2") == "accx_m_s2"
    assert suffixed("vvi", "ft/min") == "vvi_ft_min"
    assert suffixed("sensor_dsc", "%") == "sensor_dsc_percent"
    assert suffixed("waypoint", "1") == "waypoint"


def test_an_array_is_one_slot_and_a_value_for_each_place() -> None:
    attitude = _message(definition(), "attitude")
    assert [(slot.name, slot.count) for slot in attitude.slots] == [("roll_deg", 1), ("servo", 2), ("digits", 1)]
    assert [(value.name, value.slot) for value in attitude.values] == [
        ("roll_deg", 0),
        ("servo_0", 1),
        ("servo_1", 2),
        ("digits", 3),
    ]
    assert attitude.struct_format == "<fffi"


def test_flag_bits_are_values_of_one_slot() -> None:
    heartbeat = _message(definition(), "heartbeat")
    assert [(value.name, value.slot, value.bit) for value in heartbeat.values][1:3] == [("auto", 1, 0), ("stick", 1, 1)]


def test_nan_is_absent_in_the_floats_of_a_message_that_says_so() -> None:
    model = definition()
    assert [str(value.absent) for value in _message(model, "attitude").values] == ["nan", "nan", "nan", "None"]
    assert {value.absent for value in _message(model, "place").values} == {None}


def test_a_field_may_say_which_number_is_absent() -> None:
    assert [value.absent for value in _message(definition(), "heartbeat").values] == [None, None, None, -1]


def test_each_parameter_has_a_command_of_its_own_and_a_place_in_the_message() -> None:
    model = definition()
    command = _message(model, "set_k_time")
    assert (command.id, command.size, command.slots[0].type) == (61, 4, "i32")
    assert command.confirm is not None
    assert command.confirm.by == "read_back"
    assert [value.name for value in _message(model, "gains").values] == ["k_roll", "k_time"]


def test_a_profile_replaces_the_values_of_its_row_alone() -> None:
    (row,) = definition().rows
    assert [(value.index, value.name) for value in row.profiles["old"]] == [(0, "q_rad_s")]
    assert [(value.index, value.name) for value in row.profiles["new"]] == [(1, "q_deg_s")]


def test_the_real_definition_is_consistent() -> None:
    model = load(PROTOCOL / "definition")
    assert len(model.messages) == 21
    assert len(model.commands) == 77


FAULTS = {
    "a wrong size": ("telemetry", "size = 16", "size = 20", "fields are 16 bytes, size says 20"),
    "half a word": ("telemetry", 'type = "i16"', 'type = "i8"', "fields are 3 bytes"),
    "a size of half a word": (
        "commands",
        'name = "mode"\nid = 2\nsize = 4',
        'name = "mode"\nid = 2\nsize = 3',
        "size says 3",
    ),
    "an id twice": ("telemetry", "id = 1\n", "id = 0\n", "message id 0 is there twice"),
    "an id of the unused ones": ("commands", "unused_ids = [7]", "unused_ids = [2]", "stay unused"),
    "an extension with a low id": ("telemetry", "id = 0x100", "id = 12", "have ids from 0x100"),
    "an unknown unit": ("telemetry", 'unit = "deg"', 'unit = "grad"', "is not one of"),
    "an unknown type": ("telemetry", 'type = "i16"', 'type = "u16"', "is not one of"),
    "an unknown entry": ("telemetry", 'doc = "Bank."', 'doc = "Bank.", colour = "red"', "colour is not a known entry"),
    "no unit": ("telemetry", 'unit = "deg", ', "", "unit missing"),
    "no sign": ("telemetry", 'sign = "right wing down", ', "", "sign missing"),
    "no meaning of positive": ("telemetry", '"right wing down"', '"none"', "must say what positive means"),
    "an empty range": ("telemetry", "[-180.0, 180.0]", "[180.0, -180.0]", "range is empty"),
    "no doc": ("commands", 'doc = "Stop."', "", "'doc'] missing"),
    "a flag that no heartbeat has": ("commands", "armed = false", "loaded = false", "heartbeat has no flag"),
    "an absent value inside the range": ("telemetry", "absent = -1", "absent = 3", "3 cannot mean no data"),
    "a name outside the range": ("commands", "stick=1}", "stick=2}", "named value stick is outside"),
    "a frame that does not exist": ("commands", 'by = "none"', 'by = "frame", message = "ahrs"', "no message ahrs"),
    "a rule without its message": ("commands", 'by = "none"', 'by = "plan"', "a message goes with"),
    "a default outside the range": ("parameters", "default = 700", "default = 7", "default outside its range"),
    "a route that its command does not load": ("routes", "load_id = 3", "load_id = 1", "does not load it"),
    "a waypoint off the earth": ("routes", "[27.95,", "[127.95,", "is not on the earth"),
    "an unknown profile": ("xplane", "new = [", "newer = [", "is not in"),
    "an index beyond the row": ("xplane", "index = 1", "index = 8", "is over 7"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_contradiction_is_refused_with_a_clear_sentence(fault: str) -> None:
    name, old, new, sentence = FAULTS[fault]
    with pytest.raises(DefinitionError) as refused:
        definition(**{name: (old, new)})
    assert sentence in str(refused.value)

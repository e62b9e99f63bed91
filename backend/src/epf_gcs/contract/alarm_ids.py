"""What can be wrong, by name."""

from __future__ import annotations

from typing import Literal

AlarmId = Literal[
    "heartbeat_lost",
    "no_heartbeat",
    "hil_lost",
    "profile_wrong",
    "simulator_pace",
    "simulator_paused",
    "foreign_datagrams",
    "stick_lost",
    "gps_lost",
    "receiver_lost",
    "battery_low",
    "altitude_high",
    "airspeed_low",
    "airspeed_high",
    "distance_far",
    "satellites_few",
    "cpu_high",
    "frames_damaged",
    "line_floods",
    "parameter_not_confirmed",
    "card_failed",
    "flight_lost",
    "recorder_failed",
    "terrain_ahead",
    "fence_left",
    "fence_ahead",
    "surroundings_unwatched",
]

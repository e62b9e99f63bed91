"""The status while the flight process is missing: nothing in it appears live."""

from __future__ import annotations

from typing import Any, Final

_AWAY: Final = (
    "The flight process is gone or hangs, and is started again: what is shown is old, and nothing can be commanded."
)
_TASKS: Final = ("parameters", "fms", "servos")


def blank_status() -> dict[str, Any]:
    """The status before the first contact with a flight process, as `web/interface/state/schemas.py` has it."""
    return {
        "server_time_s": 0.0,
        "board": {
            "state": "closed",
            "url": None,
            "failure": None,
            "reopened": 0,
            "mode": None,
            "features": dict.fromkeys(("acknowledgements", "store", "sources", "missions"), False),
            "firmware": None,
            "ahrs_test": "off",
            "emulated": False,
            "before_emulation_url": None,
            "periods_ms": {task: {"ms": 0, "chosen": False} for task in _TASKS},
            "heartbeat_age_s": None,
            "frames_received": 0,
            "frames_damaged": 0,
            "damage": {},
            "bytes_in": 0,
            "bytes_out": 0,
            "rx_percent": 0.0,
            "tx_percent": 0.0,
        },
        "simulator": {
            "state": "closed",
            "receive_port": None,
            "send_host": None,
            "send_port": None,
            "profile": None,
            "fitting_profile": None,
            "failure": None,
            "rows": [],
            "missing_rows": [],
            "unusable": [],
            "paused": False,
            "advice": None,
            "datagrams_received": 0,
            "datagrams_dropped": 0,
            "drop_reasons": {},
            "bytes_in": 0,
            "percent": 0.0,
            "frames_to_board": 0,
            "frames_to_simulator": 0,
            "frames_skipped": {},
            "hil_round_trip_ms": {"newest": None, "p50": None, "p99": None},
        },
        "hil": {
            "source": None,
            "path": "manual",
            "stick": {
                "source": "simulator",
                "state": None,
                "client": None,
                "name": None,
                "gamepad": None,
                "samples": {},
            },
        },
        "recording": {
            "active": False,
            "file": None,
            "bytes": 0,
            "bytes_lost": 0,
            "failure": None,
            "free_bytes": None,
            "hours_left": None,
        },
        "alarms": [],
        "errors": {},
        "topics": {},
    }


def status_without_flight(last: dict[str, Any], now_s: float, lost_s: float) -> dict[str, Any]:
    """The last status, with everything that depends on the flight process marked as lost, and an alarm saying so."""
    failure = {"code": "flight_away", "detail": _AWAY, "params": {}}

    def lost(link: dict[str, Any]) -> dict[str, Any]:
        return {} if link["state"] == "closed" else {"state": "lost", "failure": failure}

    board, simulator = last["board"], last["simulator"]
    age_s = board["heartbeat_age_s"]
    return {
        **last,
        "server_time_s": now_s,
        "board": {
            **board,
            **lost(board),
            "mode": None,
            "heartbeat_age_s": None if age_s is None else age_s + now_s - last["server_time_s"],
            "rx_percent": 0.0,
            "tx_percent": 0.0,
        },
        "simulator": {
            **simulator,
            **lost(simulator),
            "rows": [],
            "missing_rows": [],
            "unusable": [],
            "paused": False,
            "percent": 0.0,
        },
        "hil": {**last["hil"], "stick": {**last["hil"]["stick"], "state": None}},
        "recording": {**last["recording"], "active": False, "failure": _AWAY},
        "alarms": [
            {
                "id": "flight_lost",
                "level": "critical",
                "since_s": lost_s,
                "until_s": None,
                "text": _AWAY,
                "params": {},
                "acknowledged": False,
            }
        ],
        "topics": {
            topic: {
                **health,
                "age_s": None if health["age_s"] is None else health["age_s"] + now_s - last["server_time_s"],
            }
            for topic, health in last["topics"].items()
        },
    }

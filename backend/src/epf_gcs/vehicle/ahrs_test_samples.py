"""The AHRS test's stream -> samples. They depend on the bytes alone, however these are cut into reads."""

from __future__ import annotations

from typing import Final

from epf_gcs.codec.ahrs_test import AhrsTest
from epf_gcs.vehicle.outside import Clock
from epf_gcs.vehicle.telemetry import Telemetry

TOPIC: Final = "ahrs_test"


class AhrsTestSamples:
    """`test` is the dialogue; whoever has the line begins, drives and ends it."""

    def __init__(self, telemetry: Telemetry, clock: Clock) -> None:
        self._telemetry = telemetry
        self._clock = clock
        self.test = AhrsTest()

    def take(self, data: bytes) -> bool:
        """Take bytes of the board's line. True if they complete an attitude."""
        attitudes = self.test.feed(data)
        for attitude in attitudes:
            self._telemetry.take(TOPIC, self._clock.now_s(), dict(attitude._asdict()))
        self._telemetry.flush()
        return bool(attitudes)

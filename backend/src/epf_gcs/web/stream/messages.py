"""What the live stream and the stream of a recording say alike."""

from __future__ import annotations

from typing import Final

from epf_gcs.codec.messages_gen import TELEMETRY
from epf_gcs.errors import ErrorCode
from epf_gcs.web.stream.viewer import MAX_RATE_HZ

TOPICS: Final = sorted(
    {message.name for message in TELEMETRY.values() if message.topic}
    | {"xplane_info", "simulator", "xplane_rows", "ahrs_test"}
)
INVALID: Final[ErrorCode] = "stream_message_invalid"
RATE_SENTENCE: Final = f"rate must be 0 (every sample) or 1..{MAX_RATE_HZ} batches a second."

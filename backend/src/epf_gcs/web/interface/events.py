"""All events of the stream, by name, with the shape of their data; the page's checks are generated from this."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from epf_gcs.contract import events
from epf_gcs.contract.answers import TrackState
from epf_gcs.contract.events import SubjectEvent
from epf_gcs.contract.flights import Job
from epf_gcs.contract.maps import MapImport, PreparedField

_SUBJECTS: Final[Mapping[SubjectEvent, type[Any]]] = {
    "job": Job,
    "map_field": PreparedField,
    "map_import": MapImport,
    "track": TrackState,
}
EVENTS: Final[Mapping[str, type[Any]]] = {**events.EVENTS, **{str(name): kind for name, kind in _SUBJECTS.items()}}

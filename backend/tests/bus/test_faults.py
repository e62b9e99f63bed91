"""An error is the same on both sides of the stream."""

from __future__ import annotations

import orjson
import pytest

from epf_gcs.bus.faults import error_of, fault_of
from epf_gcs.errors import BoardError, ConflictError, GatewayError, InvalidInputError, LinkError, NotFoundError


@pytest.mark.parametrize("kind", [InvalidInputError, NotFoundError, ConflictError, LinkError, BoardError, GatewayError])
def test_each_kind_of_error_comes_over_with_its_code_its_sentence_and_its_parts(kind: type[GatewayError]) -> None:
    there = kind("control_refused", "It is so.", client="c1", wait_s=2.5)
    here = error_of(orjson.loads(orjson.dumps(fault_of(there))))
    assert type(here) is kind
    assert (here.code, here.detail, here.params) == ("control_refused", "It is so.", {"client": "c1", "wait_s": 2.5})


def test_an_error_that_a_later_version_has_is_still_told() -> None:
    class NewerError(ConflictError):
        pass

    assert fault_of(NewerError("control_held", "It is so."))["kind"] == "internal"
    here = error_of({"kind": "newer"})
    assert type(here) is GatewayError
    assert (here.code, here.params) == ("internal", {})
    assert here.detail.endswith(".")

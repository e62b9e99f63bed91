"""The first start and the doctor over REST."""

from __future__ import annotations

from epf_gcs.errors import ConflictError
from epf_gcs.web.setup.schemas import DoctorFinding
from tests.support.gateway import Gateway
from tests.support.quick_doctor import QuickDoctor


def test_the_first_start_is_due_until_it_is_over(gateway: Gateway) -> None:
    assert gateway.http.get("/first-start").json() == {"is_due": True}
    for _ in range(2):
        assert gateway.http.delete("/first-start").status_code == 204
    assert gateway.http.get("/first-start").json() == {"is_due": False}


def test_the_doctor_looks_at_this_stations_port_in_the_language_that_is_asked_for(gateway: Gateway) -> None:
    gateway.web.doctor = QuickDoctor()
    for query, language in (("?lang=es", "es"), ("?lang=en", "en"), ("", "en")):
        finding = {"state": "note", "what": f"{gateway.web.admission.port} {language}", "mend": "sudo"}
        assert gateway.http.get(f"/doctor{query}").json() == {"findings": [finding]}
    assert gateway.http.get("/doctor?lang=fr").status_code == 422


def test_a_doctor_that_fails_is_said(gateway: Gateway) -> None:
    class Doctor:
        async def look(self, _port: int, _language: str) -> list[DoctorFinding]:
            raise ConflictError("doctor_failed", "The doctor failed.")

    gateway.web.doctor = Doctor()
    answer = gateway.http.get("/doctor")
    assert (answer.status_code, answer.json()["code"]) == (409, "doctor_failed")

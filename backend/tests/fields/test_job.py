"""The fields that an earlier run left: their folders, and nothing that a link leads to."""

from __future__ import annotations

from pathlib import Path

from epf_gcs.fields.area import Area
from epf_gcs.fields.job import FieldJob, kept_jobs
from epf_gcs.fields.order import Order


def test_a_link_to_another_folder_is_no_field_of_ours(tmp_path: Path) -> None:
    ours, foreign = tmp_path / "fields", tmp_path / "foreign"
    area = Area(((27.9, -15.4),), 1000.0)
    for folder in (ours / "a", foreign):
        FieldJob(folder.name, folder, Order("Gando", area, ())).write_order()
    (ours / "b").symlink_to(foreign)
    assert [job.id for job in kept_jobs(ours)] == ["a"]

"""What can go wrong on purpose. Each error is one sentence for a person and one stable code for a program."""

from __future__ import annotations

from typing import Literal

Params = dict[str, str | int | float | bool | None]

# Every code there is. The interface describes them, so that the page cannot forget to translate one.
ErrorCode = Literal[
    "access_key_wrong",
    "access_last_owner",
    "access_not_written",
    "access_too_many_invitations",
    "access_too_many_programs",
    "access_too_many_requests",
    "access_too_many_sessions",
    "access_too_many_tries",
    "access_too_many_waiting",
    "access_unknown",
    "access_upload_limit",
    "ahrs_test_in_flight",
    "ahrs_test_lost",
    "ahrs_test_running",
    "alarm_not_active",
    "alarms_not_written",
    "alarms_unreadable",
    "backup_disk_full",
    "backup_not_written",
    "bad_json",
    "board_line_full",
    "board_not_open",
    "body_too_large",
    "checklist_not_kept",
    "client_may_not_command",
    "client_not_yours",
    "client_silent",
    "client_unknown",
    "command_link_lost",
    "command_unknown",
    "control_held",
    "control_not_asked",
    "control_not_held",
    "control_refused",
    "control_unconfirmed",
    "data_folder_taken",
    "datagram_malformed",
    "datagram_stranger",
    "doctor_failed",
    "doctor_late",
    "emulation_running",
    "export_no_position",
    "export_stretch_empty",
    "export_topic_unknown",
    "export_topics_unused",
    "extra_missing",
    "fault_not_carried",
    "fault_out_of_range",
    "fault_unknown",
    "faults_full",
    "faults_no_simulator",
    "faults_silent",
    "fence_crosses",
    "fence_file_corners",
    "fence_file_no_fence",
    "fence_file_open",
    "fence_file_place",
    "fence_file_plan",
    "fence_file_rows",
    "fence_file_unknown",
    "field_no_field",
    "field_no_parts",
    "field_not_in_state",
    "field_not_whole",
    "field_not_written",
    "field_source_empty",
    "field_source_forbids",
    "field_source_silent",
    "field_source_unreachable",
    "field_source_wrong",
    "field_terms",
    "field_too_large",
    "field_too_many",
    "field_unknown",
    "field_worker_died",
    "first_start_not_kept",
    "flight_away",
    "flight_silent",
    "flight_delete_unconfirmed",
    "flight_disk_full",
    "flight_exists",
    "flight_import_incomplete",
    "flight_known",
    "flight_not_indexed",
    "flight_not_recorded",
    "flight_not_written",
    "flight_recording",
    "flight_unknown",
    "foreign_host",
    "foreign_origin",
    "http_error",
    "internal",
    "invalid_request",
    "job_failed",
    "job_over",
    "job_unknown",
    "jobs_busy",
    "jobs_busy_own",
    "journal_not_written",
    "journal_unreadable",
    "line_garbage",
    "link_address_invalid",
    "link_busy",
    "link_failed",
    "link_lost",
    "link_no_device",
    "link_not_serial",
    "link_permission",
    "link_refused",
    "link_timeout",
    "link_unknown_host",
    "link_unreachable",
    "listen_failed",
    "listen_unknown_host",
    "log_no_time",
    "log_unreadable",
    "map_cache_not_written",
    "map_disk_full",
    "map_exists",
    "map_file_damaged",
    "map_file_empty",
    "map_file_no_layer_json",
    "map_file_not_mesh",
    "map_file_vector",
    "map_folder_unreadable",
    "map_import_incomplete",
    "map_import_unknown",
    "map_imports_busy",
    "map_kind_unknown",
    "map_layer_unknown",
    "map_name_invalid",
    "map_not_written",
    "map_raster_converting",
    "map_raster_failed",
    "map_raster_no_place",
    "map_raster_not_height",
    "map_source_invalid",
    "map_source_local",
    "map_source_refused",
    "map_source_silent",
    "map_tile_missing",
    "mark_unknown",
    "marks_full",
    "marks_own",
    "memory_not_written",
    "memory_unreadable",
    "method_not_allowed",
    "mission_differs",
    "mission_file_above_ground",
    "mission_file_archive",
    "mission_file_cells",
    "mission_file_damaged",
    "mission_file_empty",
    "mission_file_fence",
    "mission_file_forbidden",
    "mission_file_frame",
    "mission_file_frame_differs",
    "mission_file_header",
    "mission_file_home_moves",
    "mission_file_home_unclear",
    "mission_file_no_home",
    "mission_file_no_waypoints",
    "mission_file_other",
    "mission_file_out_of_range",
    "mission_file_too_long",
    "mission_file_track",
    "mission_file_unknown",
    "mission_file_unreadable",
    "mission_file_which_number",
    "mission_invalid",
    "mission_not_read",
    "mission_refused",
    "no_such_address",
    "not_admitted",
    "not_supported",
    "nothing_to_redo",
    "nothing_to_undo",
    "own_gains_not_read",
    "parameter_out_of_range",
    "parameter_unknown",
    "parameters_not_read",
    "people_log_not_written",
    "port_taken",
    "profile_took_surfaces",
    "profile_wrong",
    "rate_invalid",
    "recording_changed",
    "recording_clock_wrong",
    "recording_empty",
    "recording_foreign",
    "recording_not_packed",
    "recording_not_whole",
    "recording_packing_unknown",
    "recording_too_large",
    "recording_two_boards",
    "recording_unknown",
    "recording_unreadable",
    "rehearsal_busy",
    "rehearsal_failed",
    "rehearsal_late",
    "replays_busy",
    "replays_own",
    "role_too_low",
    "signal_units_differ",
    "signal_unknown",
    "simulator_unknown_host",
    "source_not_taken",
    "stick_invalid",
    "stick_needs_control",
    "stick_silent",
    "stream_message_invalid",
    "surroundings_no_fence",
    "surroundings_not_kept",
    "threshold_out_of_range",
    "threshold_unknown",
    "tls_certificate_early",
    "tls_certificate_expired",
    "tls_certificate_refused",
    "tls_ends_soon",
    "tls_file_unreadable",
    "tls_key_differs",
    "tls_key_locked",
    "tls_no_authority",
    "tls_no_certificate",
    "tls_no_key",
    "tls_not_renewed",
    "track_not_kept",
    "track_not_written",
    "value_not_allowed",
]


class GatewayError(Exception):
    """Base of all expected failures.

    `code` is a stable key which the page translates; `detail` says in one English sentence which
    thing failed, why, and what to do; `params` are the values in that sentence.
    """

    def __init__(self, code: ErrorCode, detail: str, **params: str | float | bool | None) -> None:
        super().__init__(detail)
        self.code: ErrorCode = code
        self.detail = detail
        self.params: Params = params

    def as_dict(self) -> dict[str, object]:
        """Its three parts, as other processes and files have them."""
        return {"code": self.code, "detail": self.detail, "params": self.params}


class InvalidInputError(GatewayError):
    """What was asked for can never be done as asked: out of range, misspelt, of the wrong shape."""


class NotFoundError(GatewayError):
    """The named thing does not exist."""


class ConflictError(GatewayError):
    """It cannot be done now: no link, no control, not supported by this board."""


class LinkError(GatewayError):
    """A device or socket could not be opened, or was lost."""


class BoardError(GatewayError):
    """The board was asked and did not do it: refused, or no answer in time."""


class NotAdmittedError(GatewayError):
    """Nobody may ask this without a key, and none, a wrong or an ended one was shown."""


class RoleError(GatewayError):
    """The caller's role may not do this."""


class NotYoursError(GatewayError):
    """It belongs to somebody else's session."""


class TooManyError(GatewayError):
    """Too much was asked; `retry_after_s` is a parameter and says when to come back."""


class UnavailableError(GatewayError):
    """Who has to answer does not, for now."""


class NotKeptError(GatewayError):
    """The disk did not take it."""

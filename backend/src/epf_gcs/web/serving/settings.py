"""Every setting of the web process, read once from GCS_* variables; the command line has the last word."""

from __future__ import annotations

from pathlib import Path
from urllib.parse import urlsplit

from pydantic import Field, SecretStr
from pydantic_settings import BaseSettings, SettingsConfigDict

from epf_gcs.access.admission import Policy, is_this_computers
from epf_gcs.access.caller import is_in_container
from epf_gcs.data_folder.place import data_folder


class Settings(BaseSettings):
    """Immutable; made in `__main__` and handed to the parts by `app`."""

    model_config = SettingsConfigDict(env_prefix="GCS_", frozen=True)

    host: str = Field(default="127.0.0.1", description="Address to listen on; beyond 127.0.0.1 everybody needs a key.")
    port: int = Field(default=8000, ge=0, le=65535, description="TCP port to listen on; 0 takes any free one.")
    data_dir: Path = Field(default_factory=data_folder, description="Where recordings and the remembered links live.")
    page_dir: Path | None = Field(
        default=None, description="The built page; by default the one that ships with the gateway."
    )
    fd: int | None = Field(default=None, description="An inherited listening socket, in place of host and port.")
    tls: bool = Field(default=False, description="HTTPS, with an authority and a certificate of the station's own.")
    tls_cert: Path | None = Field(default=None, description="HTTPS with this certificate and its chain (PEM).")
    tls_key: Path | None = Field(default=None, description="Its key (PEM), where it is in a file of its own.")
    again: bool = Field(
        default=False, description="A restart, perhaps in flight: an expired certificate is shown rather than no page."
    )
    watchdog: int | None = Field(default=None, description="An inherited pipe for signs of life to the parent.")
    allowed_hosts: tuple[str, ...] = Field(default=(), description="More names under which browsers may ask.")
    reached_at: str | None = Field(
        default=None,
        pattern=r"^https?://([A-Za-z0-9.-]{1,253}|\[[0-9A-Fa-f:.]{2,45}\])(:[0-9]{1,5})?$",
        description="Where others reach this station, if it cannot know: the host of a container and the port that it "
        "publishes, or a proxy. Invitations and their QR codes show it, and its name may be asked.",
    )
    allowed_origins: tuple[str, ...] = Field(default=(), description="More web origins which may command.")
    local_maps: tuple[str, ...] = Field(
        default=(), description="Servers of map tiles in the own network that may be asked, as host or host:port."
    )
    trust_this_computer: bool | None = Field(
        default=None,
        description="Whether processes of this user and computer need no key; by default they do not, except in a "
        "container that listens beyond the loopback.",
    )
    allow_anyone_to_fly: bool = Field(
        default=False, description="Lets everybody on the network command the aircraft without a key."
    )
    control_by_silence: bool = Field(
        default=False,
        description="Gives control to a page that asks for it when the one that has it does not answer for 10 s.",
    )
    launcher_key: SecretStr | None = Field(default=None, description="The key of the program that started this one.")
    max_body_bytes: int = Field(default=65536, ge=1024, description="Largest request body.")

    @property
    def names(self) -> tuple[str, ...]:
        """The names and numbers under which browsers may ask, as far as they were chosen."""
        reached = urlsplit(self.reached_at or "").hostname
        return (self.host, *self.allowed_hosts, *([] if reached is None else [reached]))

    @property
    def policy(self) -> Policy:
        """What they say of strangers. By default this computer is trusted, but not in a container, where a published
        port makes strangers look like it."""
        trusts = self.trust_this_computer
        if trusts is None:
            trusts = is_this_computers(self.host) or not is_in_container()
        key = self.launcher_key
        return Policy(
            trusts,
            self.allow_anyone_to_fly,
            self.host,
            None if key is None else key.get_secret_value(),
            self.reached_at,
        )

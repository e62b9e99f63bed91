"""What the doctor says about one thing, in English or in Spanish."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from epf_gcs.launcher.spanish import SPANISH

State = Literal["ok", "note", "fault"]
Language = Literal["en", "es"]


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that was looked at. `sentence` and `advice` are English, with {names} of `values`."""

    state: State
    sentence: str
    advice: str = ""
    values: dict[str, object] = field(default_factory=dict)
    language: Language = "en"

    @property
    def what(self) -> str:
        """What was found."""
        return self._said(self.sentence)

    @property
    def mend(self) -> str:
        """What to do about it, "" if nothing."""
        return self._said(self.advice)

    def _said(self, text: str) -> str:
        if self.language == "en":
            return text.format(**self.values)
        values = {name: SPANISH.get(str(value), value) for name, value in self.values.items()}
        return SPANISH.get(text, text).format(**values)


def found(state: State, sentence: str, advice: str = "", /, **values: object) -> Finding:
    """A finding with its values by name."""
    return Finding(state, sentence, advice, values)

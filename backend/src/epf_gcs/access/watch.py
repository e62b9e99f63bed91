"""When a page counts as silent, looked at some times a second.

Looks are counted, not seconds: where this process itself was held up, what came meanwhile is taken first.
"""

from __future__ import annotations

from typing import Final, Literal, Protocol

from epf_gcs.access.changes import Page

LOOK_EVERY_S: Final = 0.1
# One ping for each silence: a line that was cut brings it when it stands again. More of them would all be answered at
# once then, and who sends that many frames at once is closed.
_PING_AT: Final = 2
# 0.7 s: with the time until the next look and the way back, control is free a second after a line was cut.
_LINE_LOOKS: Final = 7
# 2 s, when the throttle is closed, too: until then a page is only slow, for its browser answers.
_PAGE_LOOKS: Final = 20
# 10 s: a globe that loads on an old laptop keeps its page busy for some of them; longer, and the page is stuck.
_STUCK_LOOKS: Final = 100

Found = Literal["heard", "hangs", "silent"]
"""`hangs`: the browser answers, its page does nothing; or the page only begins to load, and its browser does not
answer yet. `silent`: the line is cut, or the page is stuck."""


class Line(Protocol):
    """The stream of a page. The counters only grow."""

    @property
    def heard(self) -> int:
        """Pieces of anything that came since the stream was opened, also the browser's answers to pings."""

    @property
    def said(self) -> int:
        """Messages of the page itself."""

    @property
    def is_waited_for(self) -> bool:
        """Whether it was sent something that it has not acknowledged."""

    def ping(self) -> None:
        """Make the browser answer."""

    def drop(self) -> None:
        """Close it at once: another stream takes its place."""

    def renew(self, page: Page) -> None:
        """Its page has another role or name."""


class Watch:
    """What the looks at one line have found."""

    def __init__(self) -> None:
        self._heard = self._said = -1
        self._quiet_looks = self._hung_looks = 0

    def look(self, line: Line) -> Found:
        """What is heard of this line, and of its page."""
        if line.heard != self._heard:
            self._heard, self._quiet_looks = line.heard, 0
        else:
            self._quiet_looks += 1
            if self._quiet_looks == _PING_AT:
                line.ping()
        if line.said != self._said or not line.is_waited_for:
            self._said, self._hung_looks = line.said, 0
        else:
            self._hung_looks += 1
        # A browser opens the stream by itself, but reads nothing of it, pings neither, until its page has taken the
        # stream over: a page that is busy loading is not a line that was cut.
        is_new = line.heard == 0
        if self._hung_looks >= _STUCK_LOOKS or self._quiet_looks >= (_STUCK_LOOKS if is_new else _LINE_LOOKS):
            return "silent"
        return "hangs" if self._hung_looks >= _PAGE_LOOKS or self._quiet_looks >= _LINE_LOOKS else "heard"

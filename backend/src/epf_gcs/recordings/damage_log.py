"""What could not be read of a recording, in sentences."""

from __future__ import annotations


class DamageLog:
    """Collects the faults of one file. It grows with the number of different sentences, not of faults."""

    def __init__(self) -> None:
        self._counts: dict[str, int] = {}
        self._left_out_count = self._left_out_bytes = self._first_place = 0

    def tell(self, sentence: str, count: int = 1) -> None:
        """Add a fault, as a sentence without its capital and its full stop, that was met `count` times."""
        self._counts[sentence] = self._counts.get(sentence, 0) + count

    def leave_out(self, place: int, size: int) -> None:
        """Add bytes that are no record: where they begin in the file, and how many they are."""
        if not self._left_out_count:
            self._first_place = place
        self._left_out_count += 1
        self._left_out_bytes += size

    def clear(self) -> None:
        """Forget all faults."""
        self._counts.clear()
        self._left_out_count = self._left_out_bytes = 0

    @property
    def sentences(self) -> str | None:
        """All faults with their counts; None if there are none."""
        counts = dict(self._counts)
        if self._left_out_count:
            sentence = (
                f"{self._left_out_bytes} bytes are no records and were left out, the first at byte {self._first_place}"
            )
            counts[sentence] = self._left_out_count
        told = [
            f"{sentence[0].upper()}{sentence[1:]}{f' ({count} times)' if count > 1 else ''}."
            for sentence, count in counts.items()
        ]
        return " ".join(told) or None

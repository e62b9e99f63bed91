import { type KeyboardEvent, useState } from "react";
import { parseNumber, stepped, twoReadings } from "./number";
import { usePress, useRefuse } from "./refusal";
import type { CommandState } from "./words";
import { useWords, type Words } from "./words";

/** The value, its limits and what happens with an edit. */
export interface NumberEditing {
  /** The board's value; `null` is unknown. */
  value: number | null;
  /** Called once per finished edit, not per keystroke, and only with a number in the range. */
  onCommit: (value: number) => void;
  minimum: number;
  maximum: number;
  step: number;
  /** Numbers in the reader's notation. */
  format?: ((value: number) => string) | undefined;
  /** A further check besides the range: returns the complaint about a number, or null. */
  refuse?: ((value: number) => string | null) | undefined;
  state?: CommandState | undefined;
  disabledReason?: string | undefined;
}

interface NumberEdit {
  /** The text in the field. */
  readonly shown: string;
  readonly isEdited: boolean;
  /** Why the newest edit was refused; empty if it was not. */
  readonly complaint: string;
  /** The refused edit is still in the field. */
  readonly isInvalid: boolean;
  readonly canStep: boolean;
  readonly type: (text: string) => void;
  readonly leave: () => void;
  readonly move: (direction: 1 | -1) => void;
  readonly onKeyDown: (event: KeyboardEvent) => void;
}

/** An edit of a number from the first key until it is sent, cancelled or refused. */
export function useNumberEdit(props: NumberEditing): NumberEdit {
  const { value, onCommit, minimum, maximum, step, format = String, state, disabledReason } = props;
  const words = useWords();
  const [draft, setDraft] = useState<string | null>(null);
  const [asked, setAsked] = useState<number | null>(null);
  const [complaint, setComplaint] = useState("");

  // Until the board answers, show the requested value, marked as pending.
  const held = state === "pending" && asked !== null ? asked : value;
  // A step needs a known number: from an unknown one it would jump to the end of the range.
  const from = (draft === null ? null : parseNumber(draft)) ?? held;
  const canStep = disabledReason === undefined && from !== null;
  const press = usePress(disabledReason ?? (from === null ? words.unknown : undefined));
  const pressEnter = usePress(disabledReason);
  const tell = useRefuse();

  function forget(): void {
    setDraft(null);
    setComplaint("");
  }

  function send(next: number): void {
    forget();
    if (next !== held) {
      setAsked(next);
      onCommit(next);
    }
  }

  function finish(leaves: boolean): void {
    if (draft === null) return;
    const typed = parseNumber(draft);
    const readings = twoReadings(draft, minimum, maximum);
    const refusal =
      typed === null
        ? words.notANumber
        : readings === null
          ? refusalOf(typed, props, words)
          : words.whichNumber(readings.thousand, readings.one);
    if (draft.trim() === "") {
      forget();
    } else if (typed !== null && refusal === null) {
      send(typed);
    } else {
      complain(draft, refusal ?? "", leaves);
    }
  }

  function complain(text: string, why: string, leaves: boolean): void {
    // Also where answers stand: the field may be out of sight, and the last answer there is of another edit.
    tell(words.refusedEdit(text, why));
    if (leaves) {
      // The value must not stay hidden behind an edit that is not sent.
      setDraft(null);
      setComplaint(words.refusedEdit(text, why));
    } else {
      setComplaint(held === null ? why : `${why} ${words.stillIs(format(held))}`);
    }
  }

  function move(direction: 1 | -1): void {
    press(() => from !== null && send(stepped(from, step, direction, minimum, maximum)));
  }

  function onKeyDown(event: KeyboardEvent): void {
    if (event.key === "Enter") pressEnter(() => finish(false));
    else if (event.key === "Escape") forget();
    else if (event.key === "ArrowUp") move(1);
    else if (event.key === "ArrowDown") move(-1);
    else return;
    event.preventDefault();
  }

  return {
    shown: draft ?? (held === null ? "" : format(held)),
    isEdited: draft !== null,
    complaint,
    isInvalid: complaint !== "" && draft !== null,
    canStep,
    type: (text) => {
      setDraft(text);
      setComplaint("");
    },
    leave: () => finish(true),
    move,
    onKeyDown,
  };
}

/** Why a number cannot be sent; null if it can. */
function refusalOf(
  typed: number,
  { minimum, maximum, format = String, refuse }: NumberEditing,
  words: Words,
): string | null {
  return typed < minimum || typed > maximum
    ? words.outOfRange(format(minimum), format(maximum))
    : (refuse?.(typed) ?? null);
}

import { type KeyboardEvent, useState } from "react";
import { parseNumber, stepped, type TwoReadings, twoReadings } from "./number";
import { useOpenEdit } from "./openEdits";
import { usePress, useRefuse } from "./refusal";
import type { CommandState } from "./words";
import { useWords, type Words } from "./words";

/** The value, its limits and what happens with an edit. */
export interface NumberEditing {
  /** The field's name. */
  label: string;
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
  /** The thing whose number it is, where the field stays and shows another's: a refusal belongs to its own. */
  subject?: unknown;
}

/** An edit that was not taken. */
interface Refusal {
  readonly subject: unknown;
  readonly text: string;
  readonly why: string;
  /** Not null: what was typed can mean two numbers, and the person is asked which. */
  readonly readings: TwoReadings | null;
  /** The field was left: the value is shown again. */
  readonly isLeft: boolean;
}

export interface NumberEdit {
  /** The text in the field. */
  readonly shown: string;
  readonly isEdited: boolean;
  /** Why the newest edit was refused; empty if it was not. */
  readonly complaint: string;
  /** The refused edit is still in the field. */
  readonly isInvalid: boolean;
  readonly canStep: boolean;
  /** The two numbers that the newest edit can mean; null if it is clear. */
  readonly question: TwoReadings | null;
  /** Answers the question. */
  readonly choose: (value: number) => void;
  readonly type: (text: string) => void;
  /** Take the edit, if there is one; false: it was refused, or is asked about. */
  readonly finish: () => boolean;
  readonly leave: () => void;
  readonly move: (direction: 1 | -1) => void;
  readonly onKeyDown: (event: KeyboardEvent) => void;
}

/** An edit of a number from the first key until it is sent, cancelled or refused. */
export function useNumberEdit(props: NumberEditing): NumberEdit {
  const { label, value, onCommit, minimum, maximum, step, format = String, state } = props;
  const { disabledReason, subject } = props;
  const words = useWords();
  const [draft, setDraft] = useState<string | null>(null);
  const [asked, setAsked] = useState<number | null>(null);
  const [newest, setRefusal] = useState<Refusal | null>(null);
  const refusal = newest?.subject === subject ? newest : null;

  // Until the board answers, show the requested value, marked as pending.
  const held = state === "pending" && asked !== null ? asked : value;
  const heldText = held === null ? "" : format(held);
  // A step needs a known number: from an unknown one it would jump to the end of the range.
  const from = (draft === null ? null : parseNumber(draft)) ?? held;
  const isUnclear = draft !== null && draft !== heldText && twoReadings(draft, minimum, maximum) !== null;
  const canStep = disabledReason === undefined && from !== null;
  const press = usePress(disabledReason ?? (from === null ? words.unknown : undefined));
  const pressEnter = usePress(disabledReason);
  const tell = useRefuse();
  useOpenEdit(label, refusal !== null);

  function forget(): void {
    setDraft(null);
    setRefusal(null);
  }

  function send(next: number): true {
    forget();
    if (next !== held) {
      setAsked(next);
      onCommit(next);
    }
    return true;
  }

  function finish(isLeft: boolean): boolean {
    if (draft === null) return refusal === null;
    // What the field itself showed was not typed: it is not asked about.
    if (draft.trim() === "" || draft === heldText) {
      forget();
      return true;
    }
    const typed = parseNumber(draft);
    const readings = twoReadings(draft, minimum, maximum);
    if (typed === null) return refuse(draft, words.notANumber, null, isLeft);
    return readings === null
      ? take(typed, draft, isLeft)
      : refuse(draft, words.whichNumber, readings, isLeft);
  }

  function take(typed: number, text: string, isLeft: boolean): boolean {
    const why = refusalOf(typed, props, words);
    return why === null ? send(typed) : refuse(text, why, null, isLeft);
  }

  function refuse(text: string, why: string, readings: TwoReadings | null, isLeft: boolean): false {
    // Also where answers stand: the field may be out of sight, and the last answer there is of another edit.
    if (refusal?.text !== text) tell(words.refusedEdit(text, why));
    setRefusal({ subject, text, why, readings, isLeft });
    // The value must not stay hidden behind an edit that is not sent.
    if (isLeft) setDraft(null);
    return false;
  }

  function complaintOf({ text, why, isLeft }: Refusal): string {
    if (isLeft) return words.refusedEdit(text, why);
    return held === null ? why : `${why} ${words.stillIs(heldText)}`;
  }

  function move(direction: 1 | -1): void {
    press(() => {
      // From what can be two numbers there is no step.
      if (isUnclear) finish(false);
      else if (from !== null) send(stepped(from, step, direction, minimum, maximum));
    });
  }

  function onKeyDown(event: KeyboardEvent): void {
    if (event.key === "Enter") pressEnter(() => finish(false));
    else if (event.key === "Escape") forget();
    // The question has to be there before the focus moves, so that it moves to the answers.
    else if (event.key === "Tab") {
      if (isUnclear) finish(false);
      return;
    } else if (event.key === "ArrowUp") move(1);
    else if (event.key === "ArrowDown") move(-1);
    else return;
    event.preventDefault();
  }

  return {
    shown: draft ?? heldText,
    isEdited: draft !== null,
    complaint: refusal === null ? "" : complaintOf(refusal),
    isInvalid: refusal !== null && draft !== null,
    canStep,
    question: refusal?.readings ?? null,
    choose: (chosen) => pressEnter(() => take(chosen, String(chosen), true)),
    type: (text) => {
      setDraft(text);
      setRefusal(null);
    },
    finish: () => finish(false),
    leave: () => void finish(true),
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

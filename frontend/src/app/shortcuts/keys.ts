import { isTyping } from "../../lib/typing";
import { SHORTCUTS, type Shortcut } from "./table";

/** The result of a key: the shortcut that now waits for its second key, and the one to run. */
export interface Step {
  readonly armed: Shortcut | null;
  readonly run: Shortcut | null;
}

type KeyPress = Pick<KeyboardEvent, "key" | "ctrlKey" | "altKey" | "metaKey" | "repeat" | "target">;

/** The result of a key, or null when it is no shortcut. The repeats of a held key are ignored. */
export function nextStep(pressed: KeyPress, armed: Shortcut | null): Step | null {
  const { key, ctrlKey, altKey, metaKey, repeat, target } = pressed;
  if (ctrlKey || altKey || metaKey || repeat || isTyping(target)) {
    return null;
  }
  if (armed !== null && (key === "Enter" || key === "Escape")) {
    return { armed: null, run: key === "Enter" ? armed : null };
  }
  const found = SHORTCUTS.find((shortcut) => shortcut.key === key);
  if (found === undefined) {
    return null;
  }
  return found.isArmed ? { armed: found, run: null } : { armed: null, run: found };
}

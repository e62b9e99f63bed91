import { SHORTCUTS, type Shortcut } from "./table";

/** Where keys have a meaning of their own: menus look for entries by letters, open windows keep theirs. */
const TAKEN =
  '[role="menubar"], [role="menu"], [role="dialog"], [role="alertdialog"], [contenteditable="true"], select, textarea';

/** Inputs in which nothing is typed. */
const NOT_TYPED: ReadonlySet<string> = new Set(["radio", "checkbox", "range", "button"]);

/** Whether a key pressed here belongs to the element that has the focus, and not to the page. */
export function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) {
    return false;
  }
  return (
    target.closest(TAKEN) !== null || (target instanceof HTMLInputElement && !NOT_TYPED.has(target.type))
  );
}

/** What a key brings about: the shortcut that waits for its second key from now on, and the one that runs now. */
export interface Step {
  readonly armed: Shortcut | null;
  readonly run: Shortcut | null;
}

type Pressed = Pick<KeyboardEvent, "key" | "ctrlKey" | "altKey" | "metaKey" | "repeat" | "target">;

/** The step that a key makes; null when it is none of the page's. A held key is pressed once. */
export function nextStep(pressed: Pressed, armed: Shortcut | null): Step | null {
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

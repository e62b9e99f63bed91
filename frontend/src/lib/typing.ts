/**
 * Elements that use keys themselves: menus find entries by letter, dialogs have their own keys. A menu bar does so only
 * while a menu is open: the title of a menu that was closed keeps the focus, and uses no letter.
 */
const TAKEN =
  '[role="menubar"]:has([aria-expanded="true"]), [role="menu"], [role="dialog"], [role="alertdialog"], [contenteditable="true"], select, textarea';

/** Input types without text entry. */
const NOT_TYPED: ReadonlySet<string> = new Set(["radio", "checkbox", "range", "button"]);

/** Whether the focused element uses the key itself, so that it is no shortcut. */
export function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) {
    return false;
  }
  return (
    target.closest(TAKEN) !== null || (target instanceof HTMLInputElement && !NOT_TYPED.has(target.type))
  );
}

/**
 * Focus the first button in `place` as a dialog's first focus. The dialog by itself would do it with the next animation
 * frame: a key that is pressed before that moves the focus of the page behind, is overtaken by the late focus, and the
 * Enter after it presses another button than the user chose. Returns what `initialFocus` wants: true if there is no
 * button.
 */
export function focusNow(place: HTMLElement | null): boolean {
  const button = place?.querySelector("button") ?? null;
  button?.focus();
  return button === null;
}

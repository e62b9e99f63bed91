/**
 * Put a text on the clipboard; false when the browser lets nobody do that. A page that came over plain HTTP from another
 * machine has no clipboard of its own, and copies a selection instead.
 */
export async function copyText(text: string): Promise<boolean> {
  if (navigator.clipboard !== undefined) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      // Forbidden here: a selection may still be copied.
    }
  }
  const area = document.createElement("textarea");
  area.value = text;
  area.readOnly = true;
  area.className = "visually-hidden";
  document.body.append(area);
  const before = document.activeElement;
  area.select();
  const isCopied = document.execCommand?.("copy") === true;
  area.remove();
  if (before instanceof HTMLElement) {
    before.focus();
  }
  return isCopied;
}

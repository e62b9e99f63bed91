/**
 * Copy a text to the clipboard; false if the browser forbids it. A page from another machine over plain HTTP has no
 * clipboard interface, and copies a selection instead.
 */
export async function copyText(text: string): Promise<boolean> {
  if (navigator.clipboard !== undefined) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      // Forbidden: copying a selection may still work.
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

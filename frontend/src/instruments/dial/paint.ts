/** Helpers that write to the document once per animation frame. */

/** Write an attribute only when it changes: even an equal write would make the browser draw again. */
export function setAttribute(element: Element | null, name: string, value: string): void {
  if (element !== null && element.getAttribute(name) !== value) {
    element.setAttribute(name, value);
  }
}

export function removeAttribute(element: Element | null, name: string): void {
  if (element?.hasAttribute(name)) {
    element.removeAttribute(name);
  }
}

/** Keeps the text node: a new one would be styled and laid out again. */
export function setText(element: Element | null, text: string): void {
  const node = element?.firstChild;
  if (node === null) {
    element?.append(text);
  } else if (node !== undefined && node.nodeValue !== text) {
    node.nodeValue = text;
  }
}

/** A number as the `data-` attributes hold it: fixed decimals, a plain point, and no minus before zero. */
export function attributeNumber(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? (0).toFixed(decimals) : text;
}

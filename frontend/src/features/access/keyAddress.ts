interface AddressLine {
  readonly read: () => string;
  readonly replace: (address: string) => void;
}

/**
 * Take the key from the address, where it stands behind the number sign, which no server ever sees. A key that stays in the
 * address bar is photographed, shared and kept in the browser's history.
 */
export function takeAddressedKey(line: AddressLine): string | null {
  const address = new URL(line.read());
  const fragment = new URLSearchParams(address.hash.slice(1));
  const key = fragment.get("key");
  if (key !== null) {
    fragment.delete("key");
    address.hash = fragment.toString();
    line.replace(address.toString().replace(/#$/, ""));
  }
  return key === null || key.trim() === "" ? null : key.trim();
}

/** The tab that the address names; null if none. */
export function addressedTab(line: Pick<AddressLine, "read">): string | null {
  return new URLSearchParams(new URL(line.read()).hash.slice(1)).get("tab");
}

/** The key as the station knows it: capitals, without spaces; the letters that look like digits are those digits. */
export function readKey(text: string): string {
  const plain = text.toUpperCase().replaceAll(/[\s-]/g, "").replaceAll("O", "0").replaceAll(/[IL]/g, "1");
  return plain.match(/.{1,4}/g)?.join("-") ?? "";
}

/** Whether an address names the computer on which it is opened: another one would look for the station in itself. */
export function isOfThisComputerAlone(address: string): boolean {
  return /^(localhost|.+\.localhost|127\.\d+\.\d+\.\d+|\[::1\])$/.test(new URL(address).hostname);
}

/** The address that opens a tab, with a key or without; the fragment of `address` is replaced. */
export function addressOf(address: string, tab: string): string {
  const opened = new URL(address);
  const fragment = new URLSearchParams(opened.hash.slice(1));
  fragment.set("tab", tab);
  opened.hash = fragment.toString();
  return opened.toString();
}

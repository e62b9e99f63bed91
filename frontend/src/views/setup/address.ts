/** Speeds that the board's serial port knows, in bits per second. */
export const BAUDS = ["9600", "57600", "115200", "230400", "460800", "921600"] as const;
export type Baud = (typeof BAUDS)[number];
export const DEFAULT_BAUD: Baud = "115200";

/** Choice in the port list which stands for an address that a person writes: another computer, a pseudo-terminal. */
export const OTHER = "other";

export function isBaud(text: string | undefined): text is Baud {
  return BAUDS.some((baud) => baud === text);
}

/**
 * What to open: a listed port with its speed, or the written address. A path without a scheme is a serial device,
 * because that is what people paste; null where there is nothing to open yet.
 */
export function boardUrl(choice: { port: string | null; baud: Baud; address: string }): string | null {
  const { port, baud } = choice;
  if (port !== null && port !== OTHER) {
    return `serial://${port}?baud=${baud}`;
  }
  const address = choice.address.trim();
  if (address === "") {
    return null;
  }
  return /^[a-z]+:\/\//i.test(address) ? address : `serial://${address}?baud=${baud}`;
}

/** Baud rates of the board's serial port. */
export const BAUDS = ["9600", "57600", "115200", "230400", "460800", "921600"] as const;
export type Baud = (typeof BAUDS)[number];
export const DEFAULT_BAUD: Baud = "115200";

/** The entry of the port list for a typed address: another computer, a pseudo-terminal. */
export const OTHER = "other";

export function isBaud(text: string | undefined): text is Baud {
  return BAUDS.some((baud) => baud === text);
}

/**
 * The address to open: a listed port with its baud rate, or the typed address. A path without a scheme is taken as a
 * serial device, because that is what people paste; null if nothing is chosen yet.
 */
export function boardUrl(choice: { port: string | null; baud: Baud; address: string }): string | null {
  const { port, baud } = choice;
  if (port !== null && port !== OTHER) {
    return serialUrl(port, baud);
  }
  const address = choice.address.trim();
  if (address === "") {
    return null;
  }
  return /^[a-z]+:\/\//i.test(address) ? address : serialUrl(address, baud);
}

/** Three slashes before the device: a path has its own leading one, a name like COM3 has not. */
function serialUrl(device: string, baud: Baud): string {
  return `serial://${/^[./]/.test(device) ? "" : "/"}${device}?baud=${baud}`;
}

export interface BoardChoice {
  readonly port: string | null;
  readonly baud: Baud;
  readonly address: string;
}

/** The form's choice for this address: it shows the open link until the user chooses. */
export function choiceOf(url: string | null): BoardChoice {
  if (url === null) {
    return { port: null, baud: DEFAULT_BAUD, address: "" };
  }
  const serial = /^serial:\/\/(?:\/(?=com\d))?([^?]+)(?:\?baud=(\d+))?$/i.exec(url);
  const device = serial?.[1];
  const baud = serial?.[2];
  return device === undefined
    ? { port: OTHER, baud: DEFAULT_BAUD, address: url }
    : { port: device, baud: isBaud(baud) ? baud : DEFAULT_BAUD, address: "" };
}

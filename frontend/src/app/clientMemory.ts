import type { BrowserStorage } from "../store/settings";

const KEY = "epf-gcs.client";

/** The name of this tab's last connection; null if there is none to go on with. */
export function rememberedClient(storage: BrowserStorage | null): string | null {
  try {
    const client = storage?.getItem(KEY) ?? "";
    return client === "" ? null : client;
  } catch {
    return null;
  }
}

/**
 * Keep the name of this tab's connection, so that the gateway knows the same client after a reload, which then keeps
 * control; null: the next connection gets a new name.
 */
export function rememberClient(storage: BrowserStorage | null, client: string | null): void {
  try {
    storage?.setItem(KEY, client ?? "");
  } catch {
    // Storage is forbidden: after a reload the gateway sees a new client.
  }
}

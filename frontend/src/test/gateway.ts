import type { Gateway } from "../requests/asking";
import { Rest } from "../transport/rest";

/** The way to the gateway as the page has it, over answers at the test's command. */
export function gatewayOf(fetch: (path: string, init: RequestInit) => Promise<Response>): Gateway {
  return new Rest({ client: () => "c1", fetch });
}

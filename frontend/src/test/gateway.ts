import type { Gateway } from "../requests/asking";
import { Rest } from "../transport/rest";

/** The page's interface to the gateway, with the test's answers. */
export function gatewayOf(fetch: (path: string, init: RequestInit) => Promise<Response>): Gateway {
  return new Rest({
    client: () => "c1",
    fetch,
    upload: (path, { headers, body }) => fetch(path, { method: "POST", headers, body }),
  });
}

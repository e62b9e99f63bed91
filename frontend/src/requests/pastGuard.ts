import type { Problem } from "../protocol/answers";

/**
 * What may be changed while the past is shown: alarms of the present are acknowledged, the library and its marks are
 * edited, a plan is written into a file. Nothing of it goes to the board, the simulator or the lines.
 */
const ALLOWED: readonly RegExp[] = [
  /^\/api\/v1\/alarms\/[^/]+\/acknowledge$/,
  /^\/api\/v1\/(flights|jobs)(\/|$)/,
  /^\/api\/v1\/missions\/export$/,
];

/**
 * The one place where requests stop while the past is shown, whichever control asks: a button of the past, a key, a
 * dialog that stayed open, an edit that waited for its turn. Questions pass. Null if the request may be sent.
 */
export function refusedInPast(method: string, path: string): Problem | null {
  const bare = path.split("?", 1)[0] ?? path;
  // A plan is read from the board by a GET: it occupies the line, and its answer is of the present.
  const asksBoard = /^\/api\/v1\/missions\/(flight|hil)$/.test(bare);
  if ((method === "GET" && !asksBoard) || ALLOWED.some((allowed) => allowed.test(bare))) {
    return null;
  }
  return {
    code: "in_the_past",
    detail: "The page shows the past: go back to now to command.",
    params: {},
  };
}

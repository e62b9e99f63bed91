import type { StreamEvent } from "../../protocol/envelope";
import type { ControlEvent, PageName } from "../../protocol/guards.gen";
import type { Message } from "../../store/messages";

/** What the page that got control is told, by the reason of the change; any other: that it has it. */
const GOT: ReadonlySet<string> = new Set(["granted", "handed_over", "unanswered", "waited", "taken"]);
/** What the page that had it is told; any other: who has it now. */
const GONE: ReadonlySet<string> = new Set([
  "granted",
  "taken",
  "unanswered",
  "lost",
  "silent",
  "ended",
  "released",
]);
/** Nobody meant it, or somebody else did. */
const UNMEANT: ReadonlySet<string> = new Set(["taken", "unanswered", "lost", "silent", "ended"]);

/** The reasons by which the page that got control had asked for it. */
const ASKED: ReadonlySet<string> = new Set(["asked", "granted", "unanswered", "waited", "taken"]);

/** `isAnswer`: to what the user of this page asked. */
export interface ControlMessage {
  readonly message: Message;
  readonly isAnswer: boolean;
}

/** The message for a change of control, told to who got it, who had it, and who watches; null for any other event. */
export function controlMessage({ event, data }: StreamEvent, client: string | null): ControlMessage | null {
  if (event === "control") {
    const isOwn = data.client !== null && data.client === client;
    return { message: changeMessage(data, client), isAnswer: isOwn && ASKED.has(data.reason ?? "") };
  }
  const isRefusal = event === "control_request_closed" && data.client === client && data.result === "refused";
  return isRefusal
    ? { message: { level: "warning", key: "controlSeen.refused", params: {} }, isAnswer: true }
    : null;
}

function changeMessage(change: ControlEvent, client: string | null): Message {
  const { before } = change;
  const reason = change.reason ?? "other";
  const params = { name: said(change), before: before === null ? "" : said(before) };
  const isUnmeant = UNMEANT.has(reason);
  if (change.client !== null && change.client === client) {
    return { level: "info", key: `controlGot.${GOT.has(reason) ? reason : "other"}`, params };
  }
  if (before !== null && before.client === client) {
    const key = `controlGone.${GONE.has(reason) ? reason : "other"}`;
    return { level: isUnmeant ? "warning" : "info", key, params };
  }
  if (change.client !== null) {
    return { level: "info", key: "controlSeen.changed", params };
  }
  return isUnmeant
    ? { level: "warning", key: "controlSeen.lost", params }
    : { level: "info", key: "controlSeen.free", params };
}

/** A page's name as a message carries it: one on the station's own computer is named in the user's language. */
function said({ kind, name, client }: PageName): string {
  return kind === "local" ? "@control.station" : (name ?? client ?? "");
}

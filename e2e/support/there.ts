import { readFile } from "node:fs/promises";
import { until } from "./processes.js";

/**
 * A station that runs already, in a container for one, named by the environment: GCS_STATION is its page's address,
 * GCS_STATION_KEY (or GCS_STATION_KEY_FILE) a one-time key for an owner. Its board and simulator are at its own loopback.
 */
export interface StationThere {
  url: string;
  /** The session's cookie, as a header has it. */
  cookie: string;
}

const BOARD = "tcp://127.0.0.1:5760";
/** What was entered with, for all workers: a one-time key opens once. */
const COOKIE = "GCS_STATION_COOKIE";

export const ANY_STATION = "@any-station";

export function stationThere(env: NodeJS.ProcessEnv = process.env): StationThere | undefined {
  if (env.GCS_STATION === undefined) return undefined;
  const cookie = env[COOKIE];
  if (cookie === undefined) throw new Error("nobody has entered the station that GCS_STATION names");
  return { url: env.GCS_STATION, cookie };
}

export const boardThere = (): string => process.env.GCS_STATION_BOARD ?? BOARD;

/** Before all journeys: come in as an owner, once. */
export default async function enter(): Promise<void> {
  const url = process.env.GCS_STATION;
  if (url === undefined) return;
  const key = await until("the one-time key", oneTimeKey);
  await until(`the station at ${url}`, async () => ((await fetch(`${url}/api/v1/access/me`)).ok ? true : undefined));
  process.env[COOKIE] = await cookieFor(url, key);
}

/** Exchange a one-time key for a session. */
export async function cookieFor(url: string, key: string): Promise<string> {
  const answer = await fetch(`${url}/api/v1/access/enter`, {
    method: "POST",
    body: JSON.stringify({ key, name: "journey", place: "" }),
    headers: { "Content-Type": "application/json" },
  });
  const cookie = answer.headers.get("set-cookie")?.split(";")[0];
  if (cookie === undefined) throw new Error(`the journey did not come in: ${answer.status} ${await answer.text()}`);
  return cookie;
}

async function oneTimeKey(): Promise<string | undefined> {
  const file = process.env.GCS_STATION_KEY_FILE;
  return keyIn(process.env.GCS_STATION_KEY ?? (file === undefined ? "" : await readFile(file, "utf8")));
}

/** The key in what `epf-gcs invite` prints. */
export function keyIn(text: string): string | undefined {
  return /[0-9A-Z]{4}(-[0-9A-Z]{4}){3}/.exec(text)?.[0];
}

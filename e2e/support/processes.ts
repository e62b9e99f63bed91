import { type ChildProcess, spawn } from "node:child_process";
import { createSocket } from "node:dgram";
import { createServer } from "node:net";
import path from "node:path";
import { fileURLToPath } from "node:url";

/** Root of the checkout: the product is used as it was built there. */
export const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");

/** Patience for anything that a slow machine may take long over; never a wait in itself. */
export const PATIENCE_MS = 180_000;

/** With it no worker of a station lowers its priority: beside a browser that draws a globe it would wait for minutes. */
const EQUAL_PRIORITY = { PYTHONPATH: `${ROOT}/backend/tests/support/equal_priority` };

/** A program that the test started, with all that it printed; only such programs are ever ended. */
export class Program {
  output = "";
  private readonly child: ChildProcess;
  private readonly gone: Promise<number | null>;

  constructor(
    readonly name: string,
    command: string,
    args: readonly string[],
    env: Record<string, string> = {},
  ) {
    this.child = spawn(command, args, {
      cwd: ROOT,
      env: { ...process.env, ...EQUAL_PRIORITY, ...env },
      stdio: ["ignore", "pipe", "pipe"],
    });
    this.child.stdout?.on("data", (chunk: Buffer) => (this.output += chunk.toString()));
    this.child.stderr?.on("data", (chunk: Buffer) => (this.output += chunk.toString()));
    this.gone = new Promise((resolve) => {
      this.child.once("exit", (code) => resolve(code));
      this.child.once("error", (error) => {
        this.output += `${error}\n`;
        resolve(null);
      });
    });
  }

  get pid(): number {
    if (this.child.pid === undefined) throw new Error(`${this.name} did not start:\n${this.output}`);
    return this.child.pid;
  }

  get running(): boolean {
    return this.child.exitCode === null && this.child.signalCode === null;
  }

  /** End it and wait until it is gone; by force when it does not go by itself. Returns its exit status. */
  async stop(signal: NodeJS.Signals = "SIGTERM"): Promise<number | null> {
    if (this.running) this.child.kill(signal);
    const force = setTimeout(() => this.child.kill("SIGKILL"), PATIENCE_MS);
    const code = await this.gone;
    clearTimeout(force);
    return code;
  }
}

/** Ask until the answer is there; an error counts as no answer. The last error is told when patience ends. */
export async function until<T>(what: string, ask: () => Promise<T | undefined> | T | undefined): Promise<T> {
  const end = Date.now() + PATIENCE_MS;
  let last: unknown;
  while (Date.now() < end) {
    try {
      const answer = await ask();
      if (answer !== undefined) return answer;
    } catch (error) {
      last = error;
    }
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  throw new Error(`gave up waiting for ${what}${last === undefined ? "" : `: ${last}`}`);
}

/** Journeys run beside each other: each of their workers looks for ports of its own. */
const WORKERS_MOST = 16;
const WORKER = Number(process.env.TEST_PARALLEL_INDEX ?? 0) % WORKERS_MOST;

/**
 * Below what systems give to whoever connects, so that nobody gets it between the looking and the use, and above all that
 * browsers refuse to ask (10080 is the last).
 */
function somePort(): number {
  const [first, last] = [11_000, 32_000];
  return first + WORKER + WORKERS_MOST * Math.floor((Math.random() * (last - first)) / WORKERS_MOST);
}

/** Whoever got one may not listen on it yet. */
const given = new Set<number>();

/** A port of the loopback that is free now, as `isFree` says, and that nobody was given before. */
async function freePort(isFree: (port: number) => Promise<boolean>): Promise<number> {
  return await until("a free port", async () => {
    const port = somePort();
    if (given.has(port) || !(await isFree(port))) return undefined;
    given.add(port);
    return port;
  });
}

/** A TCP port of the loopback that is free now. */
export async function freeTcpPort(): Promise<number> {
  return await freePort(
    (port) =>
      new Promise((resolve) => {
        const server = createServer();
        server.once("error", () => resolve(false));
        server.listen(port, "127.0.0.1", () => server.close(() => resolve(true)));
      }),
  );
}

/** A UDP port of the loopback that is free now. */
export async function freeUdpPort(): Promise<number> {
  return await freePort(
    (port) =>
      new Promise((resolve) => {
        const socket = createSocket("udp4");
        socket.once("error", () => resolve(false));
        socket.bind(port, "127.0.0.1", () => socket.close(() => resolve(true)));
      }),
  );
}

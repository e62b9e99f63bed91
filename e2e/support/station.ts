import { execFile } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { promisify } from "node:util";
import { Line } from "./line.js";
import { freeTcpPort, freeUdpPort, Program, ROOT, until } from "./processes.js";
import { boardThere, cookieFor, keyIn, stationThere } from "./there.js";

const BIN = `${ROOT}/.venv/bin`;

/** The programs of a station of the test's own, and the cable between its board and its gateway. */
interface Own {
  readonly line: Line;
  readonly data: string;
  readonly startGateway: () => Program;
  readonly programs: { board: Program; simulator: Program; gateway: Program };
}

/**
 * A station of the test's own: board, cable, simulator and gateway as separate programs on the loopback, and the
 * gateway's interface to prepare a flight. Nothing in it is a stand-in but the cable. Or one that runs already
 * (`there.ts`), of which nothing can be killed and no cable pulled.
 */
export class Station {
  private constructor(
    readonly url: string,
    private readonly ownParts: Own | undefined,
    private readonly udp: { receive_port: number; send_port: number },
    private readonly trustsThisComputer: boolean,
    /** The owner's session, where this computer has to come in like any other. */
    private cookie?: string,
  ) {}

  /** The station that the environment names; undefined without one. Both its links are closed. */
  static async there(): Promise<Station | undefined> {
    const there = stationThere();
    if (there === undefined) return undefined;
    const station = new Station(there.url, undefined, { receive_port: 49003, send_port: 49000 }, false, there.cookie);
    await station.land();
    await station.endFirstStart();
    return station;
  }

  /**
   * `trustsThisComputer` false: every browser of the journey is a stranger, as one of another machine is. `isNew`: its page
   * asks for what a new station has to know; of all others it shows the tabs at once.
   */
  static async start(boardOptions: readonly string[] = [], trustsThisComputer = true, isNew = false): Promise<Station> {
    const data = await mkdtemp(path.join(tmpdir(), "epf-e2e-"));
    const [boardPort, linePort, httpPort] = [await freeTcpPort(), await freeTcpPort(), await freeTcpPort()];
    const udp = { receive_port: await freeUdpPort(), send_port: await freeUdpPort() };
    const board = new Program("epf-board", `${ROOT}/firmware/build/posix/epf-board`, [
      ...["--tcp", `${boardPort}`, "--card", path.join(data, "card"), ...boardOptions],
    ]);
    const simulator = new Program("epf-sim", `${BIN}/epf-sim`, [
      ...["--listen", `127.0.0.1:${udp.send_port}`, "--send-to", `127.0.0.1:${udp.receive_port}`],
    ]);
    const startGateway = () =>
      new Program(
        "epf-gcs",
        `${BIN}/epf-gcs`,
        ["--port", `${httpPort}`, "--data-dir", path.join(data, "station")],
        trustsThisComputer ? {} : { GCS_TRUST_THIS_COMPUTER: "false" },
      );
    const station = new Station(
      `http://127.0.0.1:${httpPort}`,
      {
        line: await Line.between(linePort, boardPort),
        data,
        startGateway,
        programs: { board, simulator, gateway: startGateway() },
      },
      udp,
      trustsThisComputer,
    );
    try {
      await station.answers();
      if (!isNew) await station.endFirstStart();
    } catch (error) {
      await station.stop();
      throw error;
    }
    return station;
  }

  private get own(): Own {
    if (this.ownParts === undefined) throw new Error("this needs a station of the journey's own");
    return this.ownParts;
  }

  get gateway(): Program {
    return this.own.programs.gateway;
  }

  get line(): Line {
    return this.own.line;
  }

  /** The session of a browser that is to come in with us; undefined where it needs none. */
  get session(): { name: string; value: string; url: string } | undefined {
    const [name, value] = this.cookie?.split("=", 2) ?? [];
    return this.ownParts !== undefined || name === undefined || value === undefined
      ? undefined
      : { name, value, url: this.url };
  }

  /** A one-time key from the command line, as the owner of a station without a screen makes one. */
  async invite(role: "viewer" | "operator" | "owner"): Promise<string> {
    const { stdout } = await promisify(execFile)(`${BIN}/epf-gcs`, [
      ...["invite", "--role", role, "--data-dir", path.join(this.own.data, "station")],
    ]);
    const key = keyIn(stdout);
    if (key === undefined) throw new Error(`no key in what epf-gcs invite printed:\n${stdout}`);
    return key;
  }

  get boardUrl(): string {
    return this.ownParts === undefined ? boardThere() : `tcp://127.0.0.1:${this.line.port}`;
  }

  get simulatorLink() {
    return { ...this.udp, send_host: "127.0.0.1", profile: "xp10" };
  }

  /** Both links open, every stream on, the autopilot flies the Gando route in the simulator. */
  async fly(): Promise<void> {
    await this.openBoard();
    await this.request("PUT", "links/simulator", this.simulatorLink);
    await this.request("PUT", "hil", { source: "joystick", path: "assisted" });
    for (const name of ["start", "hil_load_gando", "autotrim_on", "autopilot_on"]) await this.command(name);
    await until("the closed loop", async () =>
      (await this.status()).simulator.hil_round_trip_ms.newest === null ? undefined : true,
    );
  }

  /** Both links closed, for the next journey. The page of the one before has control until the station notices its end. */
  async land(): Promise<void> {
    await until("both links to be closed", async () => {
      for (const name of ["board", "simulator"]) await this.request("DELETE", `links/${name}`);
      return true;
    });
  }

  async openBoard(): Promise<void> {
    await this.request("PUT", "links/board", { url: this.boardUrl });
    // Open means that the board has spoken and that it is known what it can do: commands are taken from then on.
    await until("the board", async () => ((await this.status()).board.state === "open" ? true : undefined));
  }

  /** The recorded flights, the newest first. */
  // biome-ignore lint/suspicious/noExplicitAny: a journey looks at single members of the public interface
  async flights(): Promise<any[]> {
    return (await this.request("GET", "flights")).flights;
  }

  /** What is known of one recorded flight; `current` is the one that is being recorded. */
  // biome-ignore lint/suspicious/noExplicitAny: a journey looks at single members of the public interface
  async flight(id: string): Promise<any> {
    return await this.request("GET", `flights/${id}`);
  }

  async command(name: string): Promise<void> {
    const result = await this.request("POST", `commands/${name}`, {});
    if (result.state !== "confirmed") throw new Error(`${name}: ${JSON.stringify(result)}`);
  }

  /** Alarms come by these limits (0: there is none), and end when they are taken away: nobody has acknowledged them. */
  async leaveEndedAlarms(limits: Readonly<Record<string, number>>): Promise<void> {
    const ids = Object.keys(limits).map((name) => name.replace(/_[a-z]+$/, ""));
    const areAll = async (hasEnded: boolean): Promise<true | undefined> => {
      const alarms: { id: string; until_s: number | null }[] = (await this.status()).alarms;
      const isSo = (id: string): boolean => alarms.some((one) => one.id === id && (one.until_s !== null) === hasEnded);
      return ids.every(isSo) || undefined;
    };
    await this.request("PUT", "alarms/thresholds", limits);
    await until("alarms", async () => await areAll(false));
    const none = Object.fromEntries(Object.keys(limits).map((name) => [name, 0]));
    await this.request("PUT", "alarms/thresholds", none);
    await until("the alarms' end", async () => await areAll(true));
  }

  // biome-ignore lint/suspicious/noExplicitAny: a journey looks at single members of the public interface
  async status(): Promise<any> {
    return await this.request("GET", "status");
  }

  /** Newest value of one topic, as the public interface tells it. */
  async value(topic: string, name: string): Promise<number> {
    return (await this.sample(topic)).values[name] as number;
  }

  /** Newest sample of one topic: `t_s` in Unix seconds. */
  async sample(topic: string): Promise<{ t_s: number; values: Record<string, number> }> {
    return (await this.request("GET", "telemetry"))[topic];
  }

  /** Elevator, aileron and rudder as the simulator has them, to two decimals. */
  async surfaces(): Promise<number[]> {
    const { rows } = (await this.request("GET", "telemetry")).xplane_rows.values;
    return rows["11"].slice(0, 3).map((value: number) => Number(value.toFixed(2)));
  }

  async killGateway(): Promise<void> {
    await this.own.programs.gateway.stop("SIGKILL");
  }

  async restartGateway(): Promise<void> {
    this.own.programs.gateway = this.own.startGateway();
    await this.answers();
  }

  async killBoard(): Promise<void> {
    await this.own.programs.board.stop("SIGKILL");
  }

  async stop(): Promise<void> {
    if (this.ownParts === undefined) return;
    await this.own.programs.gateway.stop();
    await this.own.programs.simulator.stop();
    await this.own.programs.board.stop();
    await this.line.pull();
    await rm(this.own.data, { recursive: true, force: true });
  }

  private async answers(): Promise<void> {
    try {
      if (!this.trustsThisComputer && this.cookie === undefined) await this.enterAsOwner();
      await until("the gateway's answer", async () => await this.status());
    } catch (error) {
      throw new Error(`${error}\nThe gateway said:\n${this.gateway.output}`);
    }
  }

  private async enterAsOwner(): Promise<void> {
    await until("the gateway", async () => ((await fetch(`${this.url}/api/v1/access/me`)).ok ? true : undefined));
    this.cookie = await cookieFor(this.url, await this.invite("owner"));
  }

  private async endFirstStart(): Promise<void> {
    await this.request("DELETE", "first-start");
  }

  // biome-ignore lint/suspicious/noExplicitAny: a journey looks at single members of the public interface
  private async request(method: string, resource: string, body?: unknown): Promise<any> {
    const answer = await fetch(`${this.url}/api/v1/${resource}`, {
      method,
      headers: {
        ...(this.cookie === undefined ? {} : { Cookie: this.cookie }),
        ...(body === undefined ? {} : { "Content-Type": "application/json" }),
      },
      ...(body === undefined ? {} : { body: JSON.stringify(body) }),
    });
    if (!answer.ok) throw new Error(`${method} ${resource}: ${answer.status} ${await answer.text()}`);
    return answer.status === 204 ? undefined : await answer.json();
  }
}

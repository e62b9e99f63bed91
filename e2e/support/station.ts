import { execFile } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { promisify } from "node:util";
import { Line } from "./line.js";
import { freeTcpPort, freeUdpPort, Program, ROOT, until } from "./processes.js";

const BIN = `${ROOT}/.venv/bin`;

/**
 * A station of the test's own: board, cable, simulator and gateway as separate programs on the loopback, and the
 * gateway's interface to prepare a flight. Nothing in it is a stand-in but the cable.
 */
export class Station {
  /** The owner's session, where this computer has to come in like any other. */
  private cookie: string | undefined;

  private constructor(
    readonly url: string,
    readonly line: Line,
    private readonly data: string,
    private readonly startGateway: () => Program,
    private readonly programs: { board: Program; simulator: Program; gateway: Program },
    private readonly udp: { receive_port: number; send_port: number },
    private readonly trustsThisComputer: boolean,
  ) {}

  /** `trustsThisComputer` false: every browser of the journey is a stranger, as one of another machine is. */
  static async start(boardOptions: readonly string[] = [], trustsThisComputer = true): Promise<Station> {
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
      await Line.between(linePort, boardPort),
      data,
      startGateway,
      { board, simulator, gateway: startGateway() },
      udp,
      trustsThisComputer,
    );
    await station.answers();
    return station;
  }

  get gateway(): Program {
    return this.programs.gateway;
  }

  /** A one-time key from the command line, as the owner of a station without a screen makes one. */
  async invite(role: "viewer" | "operator" | "owner"): Promise<string> {
    const { stdout } = await promisify(execFile)(`${BIN}/epf-gcs`, [
      ...["invite", "--role", role, "--data-dir", path.join(this.data, "station")],
    ]);
    const key = /[0-9A-Z]{4}(-[0-9A-Z]{4}){3}/.exec(stdout)?.[0];
    if (key === undefined) throw new Error(`no key in what epf-gcs invite printed:\n${stdout}`);
    return key;
  }

  get boardUrl(): string {
    return `tcp://127.0.0.1:${this.line.port}`;
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

  // biome-ignore lint/suspicious/noExplicitAny: a journey looks at single members of the public interface
  async status(): Promise<any> {
    return await this.request("GET", "status");
  }

  /** Newest value of one topic, as the public interface tells it. */
  async value(topic: string, name: string): Promise<number> {
    return (await this.request("GET", "telemetry"))[topic].values[name];
  }

  /** Elevator, aileron and rudder as the simulator has them, to two decimals. */
  async surfaces(): Promise<number[]> {
    const { rows } = (await this.request("GET", "telemetry")).xplane_rows.values;
    return rows["11"].slice(0, 3).map((value: number) => Number(value.toFixed(2)));
  }

  async killGateway(): Promise<void> {
    await this.programs.gateway.stop("SIGKILL");
  }

  async restartGateway(): Promise<void> {
    this.programs.gateway = this.startGateway();
    await this.answers();
  }

  async killBoard(): Promise<void> {
    await this.programs.board.stop("SIGKILL");
  }

  async stop(): Promise<void> {
    await this.programs.gateway.stop();
    await this.programs.simulator.stop();
    await this.programs.board.stop();
    await this.line.pull();
    await rm(this.data, { recursive: true, force: true });
  }

  private async answers(): Promise<void> {
    if (!this.trustsThisComputer && this.cookie === undefined) await this.enterAsOwner();
    await until(`the gateway's answer\n${this.programs.gateway.output}`, async () => await this.status());
  }

  private async enterAsOwner(): Promise<void> {
    await until("the gateway", async () => ((await fetch(`${this.url}/api/v1/access/me`)).ok ? true : undefined));
    const answer = await fetch(`${this.url}/api/v1/access/enter`, {
      method: "POST",
      body: JSON.stringify({ key: await this.invite("owner"), name: "journey", place: "" }),
      headers: { "Content-Type": "application/json" },
    });
    this.cookie = answer.headers.get("set-cookie")?.split(";")[0];
    if (this.cookie === undefined)
      throw new Error(`the journey did not come in: ${answer.status} ${await answer.text()}`);
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

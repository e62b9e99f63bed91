import { connect, createServer, type Server, type Socket } from "node:net";

/**
 * The network between one browser and the station. It can be cut as a radio network is: nothing arrives any more, and
 * nobody is told.
 */
export class Network {
  private readonly pairs = new Set<readonly [Socket, Socket]>();
  private isCut = false;

  private constructor(
    readonly url: string,
    private readonly server: Server,
  ) {}

  static async to(stationUrl: string): Promise<Network> {
    const { hostname, port } = new URL(stationUrl);
    const server = createServer((browser) => network.join(browser, connect(Number(port), hostname)));
    await new Promise<void>((resolve, reject) => {
      server.once("error", reject);
      server.listen(0, "127.0.0.1", resolve);
    });
    const address = server.address();
    if (address === null || typeof address === "string") throw new Error("no port for the network");
    const network = new Network(`http://127.0.0.1:${address.port}`, server);
    return network;
  }

  cut(): void {
    this.isCut = true;
  }

  /** What stood is broken, for bytes are missing; new connections go through. */
  mend(): void {
    this.isCut = false;
    this.breakAll();
  }

  async close(): Promise<void> {
    this.breakAll();
    await new Promise<void>((resolve) => this.server.close(() => resolve()));
  }

  private breakAll(): void {
    for (const pair of this.pairs) for (const socket of pair) socket.destroy();
    this.pairs.clear();
  }

  private join(browser: Socket, station: Socket): void {
    const pair = [browser, station] as const;
    this.pairs.add(pair);
    const end = () => {
      this.pairs.delete(pair);
      browser.destroy();
      station.destroy();
    };
    for (const socket of pair) socket.setNoDelay(true).on("error", end).on("close", end);
    browser.on("data", (chunk: Buffer) => this.isCut || station.write(chunk));
    station.on("data", (chunk: Buffer) => this.isCut || browser.write(chunk));
  }
}

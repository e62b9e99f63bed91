import { connect, createServer, type Server, type Socket } from "node:net";

/**
 * The cable between gateway and board: it carries bytes both ways, keeps what the gateway sent, and can be pulled.
 * The board at its far end goes on as it is, as a board does.
 */
export class Line {
  /** Every byte from the gateway towards the board since the last `forget`. */
  private sent: Buffer[] = [];
  private readonly pairs = new Set<readonly [Socket, Socket]>();
  private server: Server | undefined;

  private constructor(
    readonly port: number,
    private readonly boardPort: number,
  ) {}

  static async between(port: number, boardPort: number): Promise<Line> {
    const line = new Line(port, boardPort);
    await line.plugIn();
    return line;
  }

  get sentBytes(): Buffer {
    return Buffer.concat(this.sent);
  }

  /** The command frames among them, one by one, in hexadecimal; what is no frame is text and stands as it came. */
  get sentFrames(): string[] {
    return this.sentBytes
      .toString("hex")
      .split(/(?=2351542c)/)
      .filter((frame) => frame !== "");
  }

  forget(): void {
    this.sent = [];
  }

  /** Take the cable out: both ends see the line go, and nobody can connect. */
  async pull(): Promise<void> {
    const { server } = this;
    this.server = undefined;
    for (const pair of this.pairs) for (const socket of pair) socket.destroy();
    this.pairs.clear();
    await new Promise<void>((resolve) => (server ? server.close(() => resolve()) : resolve()));
  }

  async plugIn(): Promise<void> {
    const server = createServer((gateway) => this.join(gateway));
    await new Promise<void>((resolve, reject) => {
      server.once("error", reject);
      server.listen(this.port, "127.0.0.1", resolve);
    });
    this.server = server;
  }

  private join(gateway: Socket): void {
    const board = connect(this.boardPort, "127.0.0.1");
    const pair = [gateway, board] as const;
    this.pairs.add(pair);
    const end = () => {
      this.pairs.delete(pair);
      gateway.destroy();
      board.destroy();
    };
    for (const socket of pair) socket.setNoDelay(true).on("error", end).on("close", end);
    gateway.on("data", (chunk: Buffer) => {
      this.sent.push(chunk);
      board.write(chunk);
    });
    board.on("data", (chunk: Buffer) => gateway.write(chunk));
  }
}

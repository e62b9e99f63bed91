import type { Page } from "@playwright/test";

interface Sample {
  readonly topic: string;
  readonly t_s: number;
  readonly values: Readonly<Record<string, number>>;
}

/**
 * What a page hears on its live stream, written down by the test: what a flight of the past has to show is compared
 * with this. Begin before the page is opened.
 */
export class LiveRecord {
  private readonly samples: Sample[] = [];

  constructor(page: Page) {
    page.on("websocket", (socket) => {
      if (new URL(socket.url()).searchParams.has("flight")) return;
      socket.on("framereceived", ({ payload }) => {
        const message = JSON.parse(String(payload));
        if (message.type === "batch") this.samples.push(...message.samples);
      });
    });
  }

  /** The value that held at a moment (Unix seconds). Throws if nothing was heard before. */
  at(t_s: number, topic: string, field: string): number {
    const value = this.samples.findLast((sample) => sample.topic === topic && sample.t_s <= t_s)?.values[field];
    if (value === undefined) throw new Error(`nothing of ${topic} was heard before ${t_s}`);
    return value;
  }
}

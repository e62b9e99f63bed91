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

  /**
   * The value at a moment (Unix seconds), on the line between the samples before and after: while the page was away from
   * its station, it heard none. Throws if nothing was heard before or after.
   */
  at(t_s: number, topic: string, field: string): number {
    const before = this.samples.findLast((sample) => sample.topic === topic && sample.t_s <= t_s);
    const after = this.samples.find((sample) => sample.topic === topic && sample.t_s > t_s);
    const [from, to] = [before?.values[field], after?.values[field]];
    if (before === undefined || after === undefined || from === undefined || to === undefined) {
      throw new Error(`nothing of ${topic} was heard around ${t_s}`);
    }
    return from + ((to - from) * (t_s - before.t_s)) / (after.t_s - before.t_s);
  }
}

import { expect, test } from "vitest";
import { gatewayOf } from "../../../test/gateway";
import { packedFlight, trackBytes } from "../../../test/trackBytes";
import { ManualTimers } from "../../../test/wire";
import { createTrackLog } from "./trackRequests";

/** A gateway with a growing track under the test's control. */
class Gateway {
  readonly asked: string[] = [];
  readonly reported: unknown[] = [];
  readonly timers = new ManualTimers();
  epoch = 5;
  points = 0;
  answer: ((path: string) => Response) | null = null;
  readonly log;
  readonly takeTrackEvent;

  constructor() {
    const rest = gatewayOf(async (path) => this.#reply(path));
    const { trackLog, takeTrackEvent } = createTrackLog({
      rest,
      timers: this.timers,
      report: (error) => this.reported.push(error),
    });
    this.log = trackLog;
    this.takeTrackEvent = takeTrackEvent;
  }

  /** Run everything that is due now, then let this time pass. */
  async pass(duration_ms: number): Promise<void> {
    await this.settle();
    this.timers.pass(duration_ms);
    await this.settle();
  }

  async settle(): Promise<void> {
    for (let turn = 0; turn < 60; turn += 1) {
      await new Promise((done) => setImmediate(done));
      this.timers.pass(0);
    }
  }

  #reply(path: string): Response {
    this.asked.push(path);
    if (this.answer !== null) {
      return this.answer(path);
    }
    if (path === "/api/v1/track") {
      return Response.json({ flight_points: this.points, hil_points: 0, can_restore: false });
    }
    const query = new URL(path, "http://station").searchParams;
    if (query.get("source") === "hil") {
      return new Response(trackBytes([], { epoch: 1 }));
    }
    const isKnown = query.get("epoch") === String(this.epoch);
    const after = isKnown ? Number(query.get("after") ?? 0) : 0;
    const first = after > this.points ? 0 : after;
    return new Response(
      trackBytes(packedFlight(first, this.points - first), {
        epoch: this.epoch,
        first,
        total: this.points,
      }),
    );
  }

  /** The requests for the track of the aircraft in flight. */
  get askedOfFlight(): string[] {
    return this.asked.filter((path) => path.includes("source=flight"));
  }
}

test("nothing is asked while nobody watches; then once a second, and only for what is missing", async () => {
  const gateway = new Gateway();
  gateway.points = 100;
  await gateway.pass(5000);
  expect(gateway.asked).toEqual([]);
  const end = gateway.log.watch();
  await gateway.settle();
  gateway.points = 150;
  await gateway.pass(1000);
  expect(gateway.log.store.getState().summary.flight).toMatchObject({ count: 150, total: 150 });
  end();
  await gateway.pass(5000);
  expect(gateway.askedOfFlight).toEqual([
    "/api/v1/track/points?source=flight",
    "/api/v1/track/points?source=flight&epoch=5&after=100",
  ]);
});

test("two hours come in one piece, in slices between which the page works", async () => {
  const gateway = new Gateway();
  gateway.points = 45_000;
  const counts = new Set<number>();
  gateway.log.store.subscribe(({ summary }) => counts.add(summary.flight.count));
  gateway.log.watch();
  await gateway.settle();
  expect(gateway.askedOfFlight).toHaveLength(1);
  expect([...counts]).toEqual([10_000, 20_000, 30_000, 40_000, 45_000]);
  expect(gateway.log.points.flight.count).toBe(45_000);
});

test("another epoch starts the track over", async () => {
  const gateway = new Gateway();
  gateway.points = 3000;
  gateway.log.watch();
  await gateway.settle();
  gateway.epoch = 6;
  gateway.points = 20;
  await gateway.pass(1000);
  expect(gateway.log.points.flight.count).toBe(20);
  expect(gateway.log.store.getState().summary.flight.count).toBe(20);
});

test("an answer that is not as agreed is told and counted, leaves the track, and the next one mends it", async () => {
  const gateway = new Gateway();
  gateway.points = 50;
  gateway.log.watch();
  await gateway.settle();
  gateway.answer = () => new Response("no track");
  await gateway.pass(1000);
  expect(gateway.log.store.getState()).toMatchObject({
    malformed: 2,
    failure: { key: "problem.answer_unreadable" },
  });
  expect(gateway.log.points.flight.count).toBe(50);
  gateway.answer = null;
  gateway.points = 60;
  await gateway.pass(1000);
  expect(gateway.log.store.getState().failure).toBeNull();
  expect(gateway.log.points.flight.count).toBe(60);
});

test("a gateway that does not answer is asked again, and says why nothing comes", async () => {
  const gateway = new Gateway();
  gateway.answer = () => {
    throw new TypeError("fetch failed");
  };
  gateway.log.watch();
  await gateway.settle();
  expect(gateway.log.store.getState().failure?.key).toBe("problem.gateway_unreachable");
  gateway.answer = null;
  gateway.points = 10;
  await gateway.pass(1000);
  expect(gateway.log.store.getState()).toMatchObject({ failure: null, summary: { flight: { count: 10 } } });
});

test("an exception while a track is taken is told once, and the track goes on growing", async () => {
  const gateway = new Gateway();
  const broken = new Error("broken listener");
  gateway.points = 50;
  const recover = gateway.log.store.subscribe(({ summary }) => {
    if (summary.flight.count > 0) {
      throw broken;
    }
  });
  gateway.log.watch();
  await gateway.settle();
  expect(gateway.asked.some((path) => path.includes("source=hil"))).toBe(true);
  gateway.points = 60;
  await gateway.pass(1000);
  gateway.points = 70;
  await gateway.pass(1000);
  expect(gateway.reported).toEqual([broken]);
  expect(gateway.log.points.flight.count).toBe(70);
  recover();
  gateway.points = 80;
  await gateway.pass(1000);
  expect(gateway.log.store.getState()).toMatchObject({ failure: null, summary: { flight: { count: 80 } } });
});

test("points that lie nowhere on earth are counted and left out", async () => {
  const gateway = new Gateway();
  gateway.answer = (path) =>
    new Response(
      trackBytes(
        path.includes("flight")
          ? packedFlight(0, 3).map((point, at) =>
              at === 1 ? { ...point, latitude_e7: 2_000_000_000 } : point,
            )
          : [],
      ),
    );
  gateway.log.watch();
  await gateway.settle();
  expect(gateway.log.store.getState()).toMatchObject({ malformed: 1, summary: { flight: { count: 2 } } });
});

test("whether a cleared track can be brought back is asked once and then told by the stream", async () => {
  const gateway = new Gateway();
  gateway.log.watch();
  await gateway.pass(3000);
  expect(gateway.asked.filter((path) => path === "/api/v1/track")).toHaveLength(1);
  expect(gateway.log.store.getState().canRestore).toBe(false);
  const data = { flight_points: 0, hil_points: 0, can_restore: true };
  gateway.takeTrackEvent({ type: "event", event: "track", t_s: 1, data });
  expect(gateway.log.store.getState().canRestore).toBe(true);
});

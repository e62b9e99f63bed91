import { beforeEach, describe, expect, test } from "vitest";
import type { StreamMessage } from "../protocol/envelope";
import { aStatus } from "../test/aStatus";
import { ManualTimers, ManualWire } from "../test/wire";
import { type SocketState, StreamSocket } from "./socket";

let timers: ManualTimers;
let wires: ManualWire[];
let messages: StreamMessage[];
let states: SocketState[];
/** So long the computer slept: the clock of the timers stood still. */
let slept_ms: number;
let malformed: number;
/** What `onState` and `dial` throw once. */
let fault: { readonly onState?: SocketState["kind"]; readonly dial?: true } = {};
let reported: unknown[];

function failOnce(is: boolean): void {
  if (is) {
    fault = {};
    throw new Error("a listener");
  }
}
let socket: StreamSocket;

function wire(): ManualWire {
  const newest = wires.at(-1);
  if (newest === undefined) {
    throw new Error("nothing was dialled");
  }
  return newest;
}

const status = { type: "status", data: aStatus() };
const batch = (seq: number) => ({ type: "batch", seq, t_s: 1, missed: 0, missed_events: 0, samples: [] });

beforeEach(() => {
  timers = new ManualTimers();
  wires = [];
  messages = [];
  states = [];
  slept_ms = 0;
  malformed = 0;
  fault = {};
  reported = [];
  socket = new StreamSocket({
    dial: (listener) => {
      failOnce(fault.dial === true);
      wires.push(new ManualWire(listener));
      return wire();
    },
    timers,
    wall_ms: () => timers.now_ms() + slept_ms,
    onMessage: (message) => messages.push(message),
    onState: (state) => {
      failOnce(fault.onState === state.kind);
      states.push(state);
    },
    report: (error) => reported.push(error),
    onMalformed: () => {
      malformed += 1;
    },
  });
  socket.start();
});

describe("batches", () => {
  test("each is acknowledged after it was taken, by its number", () => {
    wire().deliver(batch(7));
    expect(messages).toHaveLength(1);
    expect(wire().sent).toEqual(['{"type":"ack","seq":7}']);
  });

  test("one that is not as agreed is acknowledged too: the gateway sends no more than four without it", () => {
    for (const seq of [1, 2, 3, 4]) {
      wire().deliver({ ...batch(seq), samples: "none" });
    }
    expect(malformed).toBe(4);
    expect(messages).toHaveLength(0);
    expect(wire().sent).toEqual([1, 2, 3, 4].map((seq) => `{"type":"ack","seq":${seq}}`));
  });

  test("one that its receiver could not take is acknowledged too", () => {
    const broken = new ManualTimers();
    const only: ManualWire[] = [];
    const failing = new StreamSocket({
      dial: (listener) => {
        const dialled = new ManualWire(listener);
        only.push(dialled);
        return dialled;
      },
      timers: broken,
      wall_ms: broken.now_ms,
      onMessage: () => {
        throw new Error("broken receiver");
      },
      onState: () => undefined,
      onMalformed: () => undefined,
      report: () => undefined,
    });
    failing.start();
    expect(() => only[0]?.deliver(batch(3))).toThrow("broken receiver");
    expect(only[0]?.sent).toEqual(['{"type":"ack","seq":3}']);
  });

  test("other messages are not acknowledged", () => {
    wire().deliver(status);
    expect(wire().sent).toEqual([]);
  });
});

test("a message that is not as agreed is dropped and counted, and the next one counts", () => {
  wire().deliver("not JSON");
  wire().deliver({ type: "batch", seq: "1" });
  wire().deliverBytes(new ArrayBuffer(4));
  wire().deliver(status);
  expect(malformed).toBe(3);
  expect(messages).toHaveLength(1);
});

describe("silence", () => {
  test("of a second is noticed, and the next message ends it", () => {
    wire().deliver(status);
    timers.pass(1300);
    expect(states.at(-1)?.kind).toBe("silent");
    wire().deliver(status);
    expect(states.at(-1)?.kind).toBe("open");
  });

  test("shorter than a second is nothing", () => {
    wire().deliver(status);
    timers.pass(900);
    wire().deliver(status);
    timers.pass(900);
    expect(states.map(({ kind }) => kind)).toEqual(["connecting", "open"]);
  });

  test("of a page that was busy itself is none: what came meanwhile is still to be read", () => {
    wire().deliver(status);
    timers.holdUp(9000);
    timers.pass(0);
    wire().deliver(status);
    timers.pass(900);
    expect(wires).toHaveLength(1);
    expect(states.map(({ kind }) => kind)).toEqual(["connecting", "open"]);
  });

  test("is noticed also where every look comes late, as in a hidden tab", () => {
    wire().deliver(status);
    for (let minute = 0; minute < 2; minute += 1) {
      timers.holdUp(60_000);
      timers.pass(0);
    }
    expect(wires[0]?.closed).toBe(true);
  });

  test("of a computer that slept is known within a second, though its browser says that the line is open", () => {
    wire().deliver(status);
    slept_ms = 90_000;
    timers.pass(750);
    expect(wires[0]?.closed).toBe(true);
    expect(wires).toHaveLength(2);
  });

  test("of a computer that slept for a moment, and of a clock that was set back, is none", () => {
    wire().deliver(status);
    slept_ms = 700;
    timers.pass(250);
    wire().deliver(status);
    slept_ms = -3_600_000;
    timers.pass(900);
    expect(wires).toHaveLength(1);
    expect(states.map(({ kind }) => kind)).toEqual(["connecting", "open"]);
  });

  test("is none while the other end says that it is still opening, which is no open line yet", () => {
    for (let second = 0; second < 10; second += 1) {
      timers.pass(1000);
      wire().deliver({ type: "opening" });
    }
    expect(wires).toHaveLength(1);
    expect(states).toEqual([{ kind: "connecting" }]);
    expect(messages).toHaveLength(0);
  });

  test("that lasts gives the line up and dials again", () => {
    wire().deliver(status);
    timers.pass(6000);
    expect(wires[0]?.closed).toBe(true);
    expect(wires.length).toBeGreaterThan(1);
  });
});

describe("after a loss", () => {
  test("the waits grow up to four seconds", () => {
    const waits: number[] = [];
    for (let attempt = 0; attempt < 7; attempt += 1) {
      wire().breakOff();
      const state = states.at(-1);
      const retry_ms = state?.kind === "waiting" ? state.retry_ms : Number.NaN;
      waits.push(retry_ms);
      timers.pass(retry_ms);
    }
    expect(waits).toEqual([250, 500, 1000, 2000, 4000, 4000, 4000]);
    expect(wires).toHaveLength(8);
  });

  test("a connection that spoke starts the waits anew", () => {
    wire().breakOff();
    timers.pass(250);
    wire().breakOff();
    timers.pass(500);
    wire().deliver(status);
    wire().breakOff();
    expect(states.at(-1)).toEqual({ kind: "waiting", retry_ms: 250 });
  });

  test("what the old line still had to say is not heard", () => {
    const old = wire();
    old.breakOff();
    timers.pass(250);
    old.deliver(status);
    expect(messages).toHaveLength(0);
  });
});

test("a stopped socket hangs up and does not come back", () => {
  const only = wire();
  socket.stop();
  timers.pass(60_000);
  expect(only.closed).toBe(true);
  expect(wires).toHaveLength(1);
});

describe("a fault of the page's own does not end the line", () => {
  test.each([
    ["when silence is said", { onState: "silent" }],
    ["when the loss is said", { onState: "waiting" }],
    ["when the next try is said", { onState: "connecting" }],
    ["when it is dialled again", { dial: true }],
  ] as const)("%s", (_when, what) => {
    wire().deliver(status);
    fault = what;
    timers.pass(30_000);
    expect(wires.length, "it was dialled again and again").toBeGreaterThan(2);
    expect(reported).toHaveLength(1);
  });

  test("when it is said to be open: the batch is taken and acknowledged", () => {
    fault = { onState: "open" };
    wire().deliver(batch(3));
    expect(messages).toHaveLength(1);
    expect(wire().sent).toEqual(['{"type":"ack","seq":3}']);
  });
});

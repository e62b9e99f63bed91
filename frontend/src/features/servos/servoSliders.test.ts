import { beforeEach, describe, expect, test } from "vitest";
import type { CommandEvent } from "../../protocol/guards.gen";
import type { Message } from "../../store/messages";
import { aStatus } from "../../test/aStatus";
import { gatewayOf } from "../../test/gateway";
import { anEvent, aShape } from "../../test/shapes";
import { ManualTimers } from "../../test/wire";
import { createServoSliders, type ServoSlidersEnds } from "./servoSliders";

interface Asked {
  readonly servo: number;
  readonly position: number;
  readonly answer: (value: object, status?: number) => Promise<void>;
}

const CONFIRMED = { state: "confirmed", by: "acknowledgement", ms: 9, reason: null };

let timers: ManualTimers;
let asked: Asked[];
let told: Message[];
let ends: ServoSlidersEnds;

beforeEach(() => {
  timers = new ManualTimers();
  asked = [];
  told = [];
  const rest = gatewayOf(
    (path, init) =>
      new Promise((resolve) => {
        expect(path).toBe("/api/v1/commands/servo_out");
        const { value } = JSON.parse(String(init.body));
        asked.push({
          ...value,
          answer: async (body, status = 200) => {
            resolve(Response.json(body, { status }));
            await new Promise((done) => setTimeout(done, 0));
          },
        });
      }),
  );
  ends = createServoSliders({ rest, timers, client: () => "c1", tell: (message) => told.push(message) });
  ends.takeStatus(aStatus());
});

function servo(index: number) {
  return ends.sliders.store.getState().servos[index];
}

function sent(): Array<readonly [number, number]> {
  return asked.map(({ servo: index, position }) => [index, position] as const);
}

function command(name: string, parts: Partial<CommandEvent>): void {
  const data = aShape("CommandEvent", { name, client: "c2", by: "acknowledgement", ms: 9, ...parts });
  ends.takeEvent(anEvent("command", data));
}

describe("moves that come faster than they go out", () => {
  test("give way to the newest, with one of a servo under way at a time", async () => {
    for (const position of [0.1, 0.2, 0.3]) {
      ends.sliders.move(4, position);
      timers.pass(60);
    }
    expect(sent()).toEqual([[4, 0.1]]);
    await asked[0]?.answer(CONFIRMED);
    expect(sent()).toEqual([
      [4, 0.1],
      [4, 0.3],
    ]);
    expect(servo(4)).toMatchObject({ position: 0.3, state: "pending" });
    await asked[1]?.answer(CONFIRMED);
    expect(servo(4)).toMatchObject({ position: 0.3, state: "confirmed" });
    timers.pass(1000);
    expect(asked).toHaveLength(2);
  });

  test("of all servos together are twenty a second, each in its turn", () => {
    for (let index = 0; index < 20; index += 1) {
      ends.sliders.move(index, 0.5);
    }
    expect(asked).toHaveLength(1);
    timers.pass(499);
    expect(asked).toHaveLength(10);
    timers.pass(1000);
    expect(sent().map(([index]) => index)).toEqual([...Array(20).keys()]);
  });
});

test("nobody knows where a servo is before it was moved", () => {
  expect(servo(0)).toEqual({ position: null, state: "idle", message: null });
});

describe("a move that failed", () => {
  test("says why, and no longer tells a position", async () => {
    ends.sliders.move(1, 0.4);
    await asked[0]?.answer({ code: "board_not_open", detail: "No board.", params: {} }, 409);
    expect(servo(1)).toMatchObject({
      position: null,
      state: "rejected",
      message: { key: "problem.board_not_open" },
    });
    expect(told).toHaveLength(1);
  });

  test("without an answer of the board says so", async () => {
    ends.sliders.move(1, 0.4);
    await asked[0]?.answer({ state: "timed_out", by: "acknowledgement", ms: 1200, reason: null });
    expect(servo(1)).toMatchObject({
      position: null,
      state: "timed_out",
      message: { key: "said.timed_out" },
    });
  });

  test("and was followed by another is forgotten for that", async () => {
    ends.sliders.move(1, 0.4);
    ends.sliders.move(1, 0.5);
    await asked[0]?.answer({ state: "timed_out", by: "acknowledgement", ms: 1200, reason: null });
    expect(servo(1)).toMatchObject({ position: 0.5, state: "pending" });
    expect(told).toEqual([]);
  });
});

test("a move that this board cannot prove is sent, and not confirmed", async () => {
  ends.sliders.move(1, 0.4);
  await asked[0]?.answer({ state: "sent", by: "none", ms: 0, reason: null });
  expect(servo(1)).toMatchObject({ position: 0.4, state: "sent" });
});

describe("what others do", () => {
  test("is shown on the slider", () => {
    command("servo_out", { state: "confirmed", value: [7, -0.25] });
    expect(servo(7)).toMatchObject({ position: -0.25, state: "confirmed" });
  });

  test("is shown only when it is done", () => {
    command("servo_out", { state: "pending", value: [7, -0.25] });
    command("servo_out", { state: "rejected", value: [7, -0.25] });
    expect(servo(7)?.position).toBeNull();
  });
});

describe("the positions are forgotten", () => {
  beforeEach(() => {
    for (const index of [0, 3, 4]) {
      command("servo_out", { state: "confirmed", value: [index, 0.5] });
    }
  });

  test("for the first four when the control mode is chosen: they follow it again", () => {
    command("servos_control_mode_hil", { state: "confirmed", client: "c1" });
    expect([0, 3, 4].map((index) => servo(index)?.position)).toEqual([null, null, 0.5]);
  });

  test("when the board is reset", () => {
    command("reset", { state: "sent" });
    expect(servo(4)?.position).toBeNull();
  });

  test("when the line to the board breaks, with what was still to go out", () => {
    ends.sliders.move(8, 0.1);
    ends.sliders.move(9, 0.1);
    ends.takeStatus(aStatus({ board: { ...aStatus().board, state: "lost" } }));
    timers.pass(1000);
    expect(sent()).toEqual([[8, 0.1]]);
    expect(servo(4)?.position).toBeNull();
  });

  test("but not by a status that says what the last one said", () => {
    ends.takeStatus(aStatus());
    expect(servo(4)?.position).toBe(0.5);
  });
});

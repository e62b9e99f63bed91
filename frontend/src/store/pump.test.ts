import { describe, expect, test, vi } from "vitest";
import { ManualFrames } from "../test/frames";
import { Pump } from "./pump";

function setup() {
  const frames = new ManualFrames();
  let revision = 0;
  const failures: unknown[] = [];
  const pump = new Pump(
    frames,
    () => revision,
    0,
    (error) => failures.push(error),
  );
  return { frames, pump, failures, arrive: () => (revision += 1) };
}

test("a burst of arrivals is one paint in the next frame", () => {
  const { frames, pump, arrive } = setup();
  const paint = vi.fn();
  pump.add("frame", paint);
  frames.show(1000);
  paint.mockClear();
  arrive();
  arrive();
  arrive();
  frames.show(1016);
  expect(paint).toHaveBeenCalledTimes(1);
});

test("frames without news paint only with the texts, ten times a second", () => {
  const { frames, pump } = setup();
  const instrument = vi.fn();
  const text = vi.fn();
  pump.add("frame", instrument);
  pump.add("text", text);
  for (let frame = 0; frame <= 60; frame += 1) {
    frames.show(1000 + (frame * 1000) / 60);
  }
  expect(text).toHaveBeenCalledTimes(11);
  expect(instrument).toHaveBeenCalledTimes(11);
});

test("with news in every frame instruments move in every frame and text does not", () => {
  const { frames, pump, arrive } = setup();
  const instrument = vi.fn();
  const text = vi.fn();
  pump.add("frame", instrument);
  pump.add("text", text);
  for (let frame = 0; frame < 60; frame += 1) {
    arrive();
    frames.show(1000 + (frame * 1000) / 60);
  }
  expect(instrument).toHaveBeenCalledTimes(60);
  expect(text).toHaveBeenCalledTimes(10);
});

test.each([
  { cost_ms: 5, name: "dear", of: "second", least: 30, most: 40 },
  { cost_ms: 12, name: "dearer", of: "third", least: 20, most: 25 },
])(
  "where frames are $name instruments move in every $of one, and texts as often as ever",
  ({ cost_ms, least, most }) => {
    const frames = new ManualFrames();
    let revision = 0;
    const source = { request: frames.request, cancel: frames.cancel };
    const pump = new Pump(
      { ...source, measure: (spent) => spent(cost_ms) },
      () => revision,
      0,
      () => undefined,
    );
    const instrument = vi.fn();
    const text = vi.fn();
    pump.add("frame", instrument);
    pump.add("text", text);
    const fly = (from: number, count: number) => {
      for (let frame = from; frame < from + count; frame += 1) {
        revision += 1;
        frames.show(1000 + (frame * 1000) / 60);
      }
    };
    fly(0, 180);
    instrument.mockClear();
    text.mockClear();
    fly(180, 60);
    expect(instrument.mock.calls.length).toBeGreaterThanOrEqual(least);
    expect(instrument.mock.calls.length).toBeLessThanOrEqual(most);
    expect(text).toHaveBeenCalledTimes(10);
  },
);

describe("a painter that throws", () => {
  const broken = new Error("broken painter");
  const fail = () => {
    throw broken;
  };

  test("stops neither the painters after it nor the texts, for as long as it is there", () => {
    const { frames, pump, arrive } = setup();
    const instrument = vi.fn();
    const text = vi.fn();
    pump.add("frame", fail);
    pump.add("frame", instrument);
    pump.add("text", fail);
    pump.add("text", text);
    for (let round = 0; round < 3; round += 1) {
      arrive();
      frames.show(1000 + 100 * round);
    }
    expect(instrument).toHaveBeenCalledTimes(3);
    expect(text).toHaveBeenCalledTimes(3);
    expect(pump.now_ms).toBe(1200);
  });

  test("is reported once, not in each frame", () => {
    const { frames, pump, failures, arrive } = setup();
    pump.add("frame", fail);
    for (let round = 0; round < 3; round += 1) {
      arrive();
      frames.show(1000 + 100 * round);
    }
    expect(failures).toEqual([broken]);
  });

  test("is tried again with each round, because what it could not paint changes", () => {
    const { frames, pump, failures, arrive } = setup();
    const paint = vi.fn().mockImplementationOnce(fail);
    pump.add("frame", paint);
    arrive();
    frames.show(1000);
    arrive();
    frames.show(1100);
    expect(paint).toHaveBeenCalledTimes(2);
    expect(failures).toEqual([broken]);
  });
});

test("nothing to paint asks for no frames", () => {
  const { frames, pump } = setup();
  const remove = pump.add("frame", () => undefined);
  expect(frames.waiting).toBe(1);
  remove();
  expect(frames.waiting).toBe(0);
});

test("a new painter paints with the very next frame", () => {
  const { frames, pump } = setup();
  pump.add("text", () => undefined);
  frames.show(1000);
  const paint = vi.fn();
  pump.add("text", paint);
  frames.show(1016);
  expect(paint).toHaveBeenCalledOnce();
  expect(pump.now_ms).toBe(1016);
});

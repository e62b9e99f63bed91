import { describe, expect, test, vi } from "vitest";
import { ManualAnimationFrames } from "../test/animationFrames";
import { Pump } from "./pump";

function setup() {
  const frames = new ManualAnimationFrames();
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

test("a burst of arrivals is one paint in the next animation frame", () => {
  const { frames, pump, arrive } = setup();
  const paint = vi.fn();
  pump.add("movement", paint);
  frames.show(1000);
  paint.mockClear();
  arrive();
  arrive();
  arrive();
  frames.show(1016);
  expect(paint).toHaveBeenCalledTimes(1);
});

test("animation frames without news paint only with the texts, ten times a second", () => {
  const { frames, pump } = setup();
  const instrument = vi.fn();
  const text = vi.fn();
  pump.add("movement", instrument);
  pump.add("text", text);
  for (let frame = 0; frame <= 60; frame += 1) {
    frames.show(1000 + (frame * 1000) / 60);
  }
  expect(text).toHaveBeenCalledTimes(11);
  expect(instrument).toHaveBeenCalledTimes(11);
});

test("with news in every animation frame instruments move in each and text does not", () => {
  const { frames, pump, arrive } = setup();
  const instrument = vi.fn();
  const text = vi.fn();
  pump.add("movement", instrument);
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
  "where animation frames are $name instruments move in every $of one, and texts as often as ever",
  ({ cost_ms, least, most }) => {
    const frames = new ManualAnimationFrames();
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
    pump.add("movement", instrument);
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
    pump.add("movement", fail);
    pump.add("movement", instrument);
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

  test("is reported once, not in each animation frame", () => {
    const { frames, pump, failures, arrive } = setup();
    pump.add("movement", fail);
    for (let round = 0; round < 3; round += 1) {
      arrive();
      frames.show(1000 + 100 * round);
    }
    expect(failures).toEqual([broken]);
  });

  test("is tried again with each round, because what it could not paint changes", () => {
    const { frames, pump, failures, arrive } = setup();
    const paint = vi.fn().mockImplementationOnce(fail);
    pump.add("movement", paint);
    arrive();
    frames.show(1000);
    arrive();
    frames.show(1100);
    expect(paint).toHaveBeenCalledTimes(2);
    expect(failures).toEqual([broken]);
  });
});

test("another moment is painted with the very next animation frame, texts too, once", () => {
  const { frames, pump, arrive } = setup();
  const instrument = vi.fn();
  const text = vi.fn();
  pump.add("movement", instrument);
  pump.add("text", text);
  frames.show(1000);
  arrive();
  pump.hurry();
  frames.show(1016);
  frames.show(1033);
  expect([instrument, text].map((paint) => paint.mock.calls)).toEqual([
    [[1000], [1016]],
    [[1000], [1016]],
  ]);
});

test("nothing to paint asks for no animation frames", () => {
  const { frames, pump } = setup();
  const remove = pump.add("movement", () => undefined);
  expect(frames.waiting).toBe(1);
  remove();
  expect(frames.waiting).toBe(0);
});

test("a new painter paints with the very next animation frame", () => {
  const { frames, pump } = setup();
  pump.add("text", () => undefined);
  frames.show(1000);
  const paint = vi.fn();
  pump.add("text", paint);
  frames.show(1016);
  expect(paint).toHaveBeenCalledOnce();
  expect(pump.now_ms).toBe(1016);
});

test("the loop goes on while any painter is left, of either rate", () => {
  const { frames, pump } = setup();
  const removeMovement = pump.add("movement", () => undefined);
  const removeText = pump.add("text", () => undefined);
  removeMovement();
  expect(frames.waiting).toBe(1);
  const removeOther = pump.add("movement", () => undefined);
  removeText();
  expect(frames.waiting).toBe(1);
  removeOther();
  expect(frames.waiting).toBe(0);
});

test("a loop that was ended begins again with the next painter", () => {
  const { frames, pump } = setup();
  pump.add("movement", () => undefined)();
  const paint = vi.fn();
  pump.add("movement", paint);
  frames.show(1000);
  expect(paint).toHaveBeenCalledOnce();
});

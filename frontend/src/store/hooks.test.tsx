import { act, render, screen } from "@testing-library/react";
import { useCallback, useRef } from "react";
import { describe, expect, test } from "vitest";
import { ManualAnimationFrames } from "../test/animationFrames";
import { begin, createCommands } from "./commands";
import { createConnection } from "./connection";
import {
  type Page,
  PageContext,
  useCommandEntry,
  useConnection,
  usePart,
  useSettings,
  useTelemetry,
} from "./hooks";
import { Parts, partName } from "./parts";
import { Pump } from "./pump";
import { createSettings } from "./settings";
import { TelemetryStore } from "./telemetry";
import { usePaint } from "./usePaint";

const frames = new ManualAnimationFrames();
const telemetry = new TelemetryStore();
// The parts of a page that these hooks use.
const page = {
  telemetry,
  pump: new Pump(
    { request: frames.request, cancel: frames.cancel },
    () => telemetry.revision,
    0,
    () => undefined,
  ),
  connection: createConnection(),
  commands: createCommands(),
  settings: createSettings(null, ["es"]),
  parts: new Parts(),
} as Partial<Page> as Page;
let now_ms = 0;

/** A sample of ahrs arrives, and an animation frame follows a tenth of a second later. */
function hear(roll_deg: number): void {
  act(() => {
    telemetry.apply(now_ms / 1000, [{ topic: "ahrs", t_s: now_ms / 1000, values: { roll_deg } }], now_ms);
    now_ms += 100;
    frames.show(now_ms);
  });
}

describe("a component that paints", () => {
  test("shows each value without being rendered again", () => {
    let renders = 0;
    function Painted() {
      renders += 1;
      const output = useRef<HTMLOutputElement>(null);
      const paint = useCallback((store: TelemetryStore, at_ms: number) => {
        if (output.current !== null) {
          output.current.textContent = String(store.liveNumber("ahrs", "roll_deg", at_ms));
        }
      }, []);
      usePaint("movement", paint);
      return <output ref={output} />;
    }
    render(<Painted />, { wrapper: ({ children }) => <PageContext value={page}>{children}</PageContext> });
    for (const roll_deg of [1, 2, 3]) {
      hear(roll_deg);
      expect(screen.getByRole("status").textContent).toBe(String(roll_deg));
    }
    expect(renders).toBe(1);
  });

  test("is painted no more once it is gone", () => {
    let paints = 0;
    function Counted() {
      const paint = useCallback(() => {
        paints += 1;
      }, []);
      usePaint("text", paint);
      return null;
    }
    const { unmount } = render(<Counted />, {
      wrapper: ({ children }) => <PageContext value={page}>{children}</PageContext>,
    });
    hear(1);
    expect(paints).toBe(1);
    unmount();
    hear(2);
    expect(paints).toBe(1);
  });
});

test("a component that selects a word is rendered when the word changes and not when a number does", () => {
  let renders = 0;
  function Worded() {
    renders += 1;
    return (
      <p>
        {useTelemetry((store, at_ms) =>
          (store.liveNumber("ahrs", "roll_deg", at_ms) ?? 0) > 10 ? "bank" : "level",
        )}
      </p>
    );
  }
  render(<Worded />, { wrapper: ({ children }) => <PageContext value={page}>{children}</PageContext> });
  hear(1);
  const settled = renders;
  hear(2);
  hear(3);
  expect(renders).toBe(settled);
  hear(20);
  expect(screen.getByText("bank")).toBeTruthy();
  expect(renders).toBe(settled + 1);
});

test("a component outside of the page fails at once, not with empty values", () => {
  function Lost() {
    useTelemetry(() => null);
    return null;
  }
  expect(() => render(<Lost />)).toThrow("PageContext");
});

test("a component sees each store change, and its feature's own part", () => {
  const name = partName<string>("a feature");
  page.parts.with(name, "its part");
  function Seeing() {
    const entry = useCommandEntry("ahrs");
    const phase = useConnection((connection) => connection.phase);
    const language = useSettings((settings) => settings.language);
    return <output>{[usePart(name), phase, language, entry?.state ?? "nothing"].join(" ")}</output>;
  }
  render(<Seeing />, { wrapper: ({ children }) => <PageContext value={page}>{children}</PageContext> });
  const seen = (): string | null => screen.getByRole("status").textContent;
  expect(seen()).toBe("its part connecting es nothing");
  act(() => {
    begin(page.commands, "ahrs", "on");
    page.connection.setState({ phase: "open" });
    page.settings.setState({ language: "en" });
  });
  expect(seen()).toBe("its part open en pending");
});

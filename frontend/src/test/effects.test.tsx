import { render, screen } from "@testing-library/react";
import { useEffect, useState } from "react";
import { afterEach, expect, test, vi } from "vitest";

afterEach(() => vi.unstubAllGlobals());

function beBusy(duration_ms: number): void {
  const begin_ms = performance.now();
  while (performance.now() - begin_ms < duration_ms);
}

function Late({ onEffect }: { onEffect: () => void }) {
  // Longer than React's slice of time, so that it leaves the effects for a turn of their own.
  beBusy(20);
  useEffect(onEffect, [onEffect]);
  return <p>late</p>;
}

function Loading({ onEffect }: { onEffect: () => void }) {
  const [isLoaded, setLoaded] = useState(false);
  useEffect(() => void import("./aStatus").then(() => setLoaded(true)), []);
  return isLoaded && <Late onEffect={onEffect} />;
}

test("what a wait has found has run its effects, on a slow machine too", async () => {
  const start = globalThis.setTimeout;
  vi.stubGlobal("setTimeout", (run: () => void, wait_ms: number) => {
    const timer = start(run, wait_ms);
    beBusy(5);
    return timer;
  });
  const onEffect = vi.fn();
  render(<Loading onEffect={onEffect} />);
  await screen.findByText("late");
  expect(onEffect).toHaveBeenCalledOnce();
});

import { expect, test } from "vitest";
import { tellTiming } from "./timers";

test("who listens hears how long it took, and nothing is kept", async () => {
  const heard = new Promise<PerformanceEntry[]>((resolve) => {
    const observer = new PerformanceObserver((list) => {
      observer.disconnect();
      resolve(list.getEntries());
    });
    observer.observe({ entryTypes: ["measure"] });
  });
  const start_ms = performance.now() - 25;
  tellTiming("some.work", start_ms);
  const [entry] = await heard;
  expect(entry?.name).toBe("some.work");
  expect(entry?.startTime).toBeCloseTo(start_ms, 3);
  expect(entry?.duration).toBeGreaterThanOrEqual(25);
  expect(performance.getEntriesByType("measure")).toEqual([]);
});

/**
 * Reports a duration, since `start_ms` of `performance.now()`, to the browser's performance tools and to a bench.
 * Nothing is stored.
 */
export function tellTiming(name: string, start_ms: number): void {
  performance.measure(name, { start: start_ms });
  performance.clearMeasures(name);
}

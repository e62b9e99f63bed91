/**
 * Tells the browser's own tools how long something took, since `start_ms` of `performance.now()`: their timeline shows
 * it, and a bench that listens hears it. Nothing is kept, however long the page is open.
 */
export function tellTiming(name: string, start_ms: number): void {
  performance.measure(name, { start: start_ms });
  performance.clearMeasures(name);
}

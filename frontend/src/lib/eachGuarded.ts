/** Call with each item; an exception at one is reported and does not keep the others from their turn. */
export function eachGuarded<T>(
  items: Iterable<T>,
  call: (item: T) => void,
  report: (error: unknown) => void,
): void {
  for (const item of items) {
    try {
      call(item);
    } catch (error) {
      report(error);
    }
  }
}

/** Local time with 24 hours: Unix seconds -> "14:05:09". */
export function formatClock(at_s: number): string {
  const at = new Date(at_s * 1000);
  return [at.getHours(), at.getMinutes(), at.getSeconds()].map(twoDigits).join(":");
}

/** With the date in front if it is not the day of `now_s`: "2026-11-20 14:05:09". */
export function formatMoment(at_s: number, now_s: number): string {
  const [at, now] = [new Date(at_s * 1000), new Date(now_s * 1000)];
  return at.toDateString() === now.toDateString() ? formatClock(at_s) : formatDateTime(at_s);
}

/** Local date and time: Unix seconds -> "2026-11-20 14:05:09". */
export function formatDateTime(at_s: number): string {
  const at = new Date(at_s * 1000);
  return `${at.getFullYear()}-${twoDigits(at.getMonth() + 1)}-${twoDigits(at.getDate())} ${formatClock(at_s)}`;
}

function twoDigits(number: number): string {
  return String(number).padStart(2, "0");
}

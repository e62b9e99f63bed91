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

/** Time of a flight: "1:02:03", "2:03", "2:03.4". */
export function formatFlightTime(at_s: number, decimals: 0 | 1 | 2 = 0): string {
  const units = Math.max(0, Math.round(at_s * 10 ** decimals));
  const whole_s = Math.floor(units / 10 ** decimals);
  const hours = Math.floor(whole_s / 3600);
  const minutes = Math.floor(whole_s / 60) % 60;
  const seconds = String(whole_s % 60).padStart(2, "0");
  const fraction = decimals === 0 ? "" : `.${String(units % 10 ** decimals).padStart(decimals, "0")}`;
  return hours > 0
    ? `${hours}:${String(minutes).padStart(2, "0")}:${seconds}${fraction}`
    : `${minutes}:${seconds}${fraction}`;
}

function twoDigits(number: number): string {
  return String(number).padStart(2, "0");
}

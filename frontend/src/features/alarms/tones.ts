/** One beep: starts `at_s` after the signal begins. */
export interface Beep {
  readonly at_s: number;
  readonly duration_s: number;
  readonly frequency_hz: number;
  readonly wave: "sine" | "triangle";
  /** Share of the chosen volume. */
  readonly level: number;
}

/** A warning is a soft chime that rises once; a critical alarm six hard beeps that go up and down. */
export const SIGNALS: Readonly<Record<"warning" | "critical", readonly Beep[]>> = {
  warning: [
    { at_s: 0, duration_s: 0.22, frequency_hz: 660, wave: "sine", level: 0.7 },
    { at_s: 0.2, duration_s: 0.34, frequency_hz: 880, wave: "sine", level: 0.7 },
  ],
  critical: [0, 1, 2, 3, 4, 5].map((number) => ({
    at_s: number * 0.16,
    duration_s: 0.13,
    frequency_hz: number % 2 === 0 ? 1480 : 1110,
    wave: "triangle",
    level: 1,
  })),
};

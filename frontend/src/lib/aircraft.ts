/** The two aircraft, each with its plan and its track: the real one, and that of the simulator. */
export const AIRCRAFT = ["flight", "hil"] as const;
export type Aircraft = (typeof AIRCRAFT)[number];

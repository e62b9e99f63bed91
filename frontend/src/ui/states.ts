/** Freshness of a value: received within three periods of its stream, older, or never received. */
export type DataState = "live" | "stale" | "none";

/** State of a request to the board. `sent`: it was sent, and nothing will ever prove its arrival. */
export type CommandState = "idle" | "pending" | "confirmed" | "rejected" | "timed_out" | "sent";

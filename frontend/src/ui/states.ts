/** How fresh a shown value is: heard within three periods of its stream, older than that, or never heard. */
export type DataState = "live" | "stale" | "none";

/** What became of something asked of the board. `sent`: it went out, and nothing will ever prove its arrival. */
export type CommandState = "idle" | "pending" | "confirmed" | "rejected" | "timed_out" | "sent";

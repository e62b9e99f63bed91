/// Restarts of the processor by its own program. Their reason is kept in memory that no start clears.
#ifndef RESTART_H
#define RESTART_H

/// Restart at once, and keep the first 39 characters of `reason`.
_Noreturn void restart_because(const char* reason);

/// Why the program restarted itself; NULL after power-on or the reset button. Call it once at the start: it also clears
/// the reason.
const char* restart_reason(void);

#endif

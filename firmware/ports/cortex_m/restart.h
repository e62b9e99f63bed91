/// Restarts of the processor by its own program, and their reason, which survives in memory that no start clears.
#ifndef RESTART_H
#define RESTART_H

/// Start anew at once. The first 39 characters of `reason` outlive it.
_Noreturn void restart_because(const char* reason);

/// Why the program restarted itself, or NULL after power-on or the reset button. Asked once at the start, it is
/// forgotten for the next one.
const char* restart_reason(void);

#endif

#include "restart.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "common/crc32.h"
#include "core.h"

enum
{
    reason_bytes = 40
};

/// In memory that the start does not clear. After power-on its contents are random, which the check detects.
__attribute__((section(".noinit"))) static struct
{
    uint8_t reason[reason_bytes]; ///< text, padded with zeros
    uint32_t check;
} kept;

_Noreturn void restart_because(const char* reason)
{
    __asm volatile("cpsid i" ::: "memory");
    memset(&kept, 0, sizeof kept);
    const size_t length = strlen(reason);
    memcpy(kept.reason, reason, length < reason_bytes ? length : reason_bytes - 1U);
    kept.check = crc32_of(kept.reason, reason_bytes);
    core_barrier();
    CORE_RESET_CONTROL = CORE_RESET_CONTROL_RESET;
    for (;;)
    {
        core_barrier(); // the reset comes a few cycles later
    }
}

const char* restart_reason(void)
{
    const bool is_kept = kept.reason[0] != 0U && kept.check == crc32_of(kept.reason, reason_bytes);
    kept.check = ~kept.check;
    return is_kept ? (const char*)kept.reason : NULL;
}

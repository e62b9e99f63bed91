#include "pause.h"

#include <stdint.h>

#include "FreeRTOS.h"
#include "task.h"

#include "machine.h"

enum
{
    turn_cycles = 3 ///< of the loop below, at least
};

void pause_a_millisecond(void* unused)
{
    (void)unused;
    if (xTaskGetSchedulerState() == taskSCHEDULER_RUNNING)
    {
        vTaskDelay(2); // the tick that runs already may end at once
        return;
    }
    for (uint32_t turns = machine_clock_hz / 1000U / (uint32_t)turn_cycles; turns > 0U; turns--)
    {
        __asm volatile("nop");
    }
}

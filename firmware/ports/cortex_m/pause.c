#include "pause.h"

#include <stdint.h>

#include "FreeRTOS.h"
#include "task.h"

#include "machine.h"

enum
{
    turn_cycles = 3 ///< least number of cycles of one turn of the loop below
};

void pause_a_millisecond(void* unused)
{
    (void)unused;
    if (xTaskGetSchedulerState() == taskSCHEDULER_RUNNING)
    {
        vTaskDelay(2); // one tick more, because the present one may end at once
        return;
    }
    for (uint32_t turns = machine_clock_hz / 1000U / (uint32_t)turn_cycles; turns > 0U; turns--)
    {
        __asm volatile("nop");
    }
}

#include "hal/time.h"

#include "FreeRTOS.h"
#include "task.h"

#include "core.h"
#include "restart.h"

// The kernel names these functions; nothing else may call them, so they have no header.
void vApplicationIdleHook(void);
void vApplicationStackOverflowHook(TaskHandle_t task, char* name);

static const uint32_t us_per_tick = 1000000U / configTICK_RATE_HZ;

uint32_t time_ms(void)
{
    return (uint32_t)xTaskGetTickCount() * (1000U / configTICK_RATE_HZ);
}

/// Microseconds: the ticks and the elapsed part of the present one. The kernel calls it while it switches tasks with
/// interrupts masked, so a tick that is over but not counted yet is pending.
uint32_t cortex_m_run_time_us(void)
{
    const uint32_t reload = CORE_SYSTICK_RELOAD;
    uint32_t ticks = (uint32_t)xTaskGetTickCountFromISR();
    uint32_t value = CORE_SYSTICK_VALUE;
    if ((CORE_INTERRUPT_STATE & CORE_INTERRUPT_STATE_TICK_PENDS) != 0U)
    {
        value = CORE_SYSTICK_VALUE;
        ticks++;
    }
    const uint32_t cycles_per_us = (reload + 1U) / us_per_tick;
    return ticks * us_per_tick + (reload - value) / cycles_per_us;
}

void vApplicationIdleHook(void)
{
    __asm volatile("wfi");
}

void vApplicationStackOverflowHook(TaskHandle_t task, char* name)
{
    (void)task;
    (void)name;
    restart_because("stack overflow");
}

/// Kernel settings of the board on a Cortex-M4F processor. All other settings keep the kernel's defaults.
#ifndef FREERTOS_CONFIG_H
#define FREERTOS_CONFIG_H

#include <stddef.h>
#include <stdint.h>

// Every task, stack and mutex is a static object: there is no heap to run out of.
#define configSUPPORT_STATIC_ALLOCATION 1
#define configSUPPORT_DYNAMIC_ALLOCATION 0
#define configKERNEL_PROVIDED_STATIC_MEMORY 1

#define configUSE_PREEMPTION 1
#define configUSE_TIME_SLICING 0 // tasks of one priority never preempt each other
#define configTICK_RATE_HZ 1000
#define configTICK_TYPE_WIDTH_IN_BITS TICK_TYPE_WIDTH_32_BITS
#define configMAX_PRIORITIES 9
#define configMAX_TASK_NAME_LEN 16
#define configMINIMAL_STACK_SIZE 128 // words, of the idle task
#define configSTACK_DEPTH_TYPE size_t

#define configUSE_MUTEXES 1
#define configUSE_TIMERS 0
#define configUSE_CO_ROUTINES 0
#define configUSE_TASK_NOTIFICATIONS 1
#define configUSE_PORT_OPTIMISED_TASK_SELECTION 1

#define configUSE_IDLE_HOOK 1 // the processor sleeps until the next interrupt
#define configUSE_TICK_HOOK 1 // looks for received bytes whose interrupt woke nobody
#define configCHECK_FOR_STACK_OVERFLOW 2

// The processor's clock is known once the machine has set it up (machine.h).
extern uint32_t machine_clock_hz;
#define configCPU_CLOCK_HZ machine_clock_hz

// Priorities of interrupts: the kernel's own are the lowest. Those above 0x50 (smaller numbers) must not call the
// kernel. Only as many of the upper bits count as the processor has.
#define configKERNEL_INTERRUPT_PRIORITY 0xFF
#define configMAX_SYSCALL_INTERRUPT_PRIORITY 0x50

// Run time in microseconds (time.c): the load of the two processors and the shell's `tasks` come from it.
#define configGENERATE_RUN_TIME_STATS 1
#define configRUN_TIME_COUNTER_TYPE uint32_t
#define configUSE_TRACE_FACILITY 1
uint32_t cortex_m_run_time_us(void);
#define portCONFIGURE_TIMER_FOR_RUN_TIME_STATS()
#define portGET_RUN_TIME_COUNTER_VALUE() cortex_m_run_time_us()

#define INCLUDE_vTaskDelay 1
#define INCLUDE_vTaskSuspend 1
#define INCLUDE_xTaskDelayUntil 1
#define INCLUDE_xTaskGetIdleTaskHandle 1
#define INCLUDE_xTaskGetCurrentTaskHandle 1
#define INCLUDE_xTaskGetSchedulerState 1
#define INCLUDE_uxTaskGetStackHighWaterMark 1

_Noreturn void restart_because(const char* reason);
#define configASSERT(condition)                                                                                        \
    do                                                                                                                 \
    {                                                                                                                  \
        if (!(condition))                                                                                              \
        {                                                                                                              \
            restart_because("assertion");                                                                              \
        }                                                                                                              \
    } while (0)

#endif

/// Kernel settings of the board on a PC. All other settings keep the kernel's defaults.
#ifndef FREERTOS_CONFIG_H
#define FREERTOS_CONFIG_H

#include <limits.h>
#include <stddef.h>

// Every task, stack and mutex is a static object: there is no heap to run out of.
#define configSUPPORT_STATIC_ALLOCATION 1
#define configSUPPORT_DYNAMIC_ALLOCATION 0
#define configKERNEL_PROVIDED_STATIC_MEMORY 1

#define configUSE_PREEMPTION 1
#define configUSE_TIME_SLICING 0 // tasks of one priority never preempt each other
#define configTICK_RATE_HZ 1000
#define configTICK_TYPE_WIDTH_IN_BITS TICK_TYPE_WIDTH_64_BITS
#define configMAX_PRIORITIES 9
#define configMAX_TASK_NAME_LEN 16

// Words. The kernel's port runs each task on the stack of a thread; this stack only holds data about that thread.
#define configMINIMAL_STACK_SIZE 256
#define configSTACK_DEPTH_TYPE size_t

#define configUSE_MUTEXES 1
#define configUSE_TIMERS 0
#define configUSE_CO_ROUTINES 0
#define configUSE_TASK_NOTIFICATIONS 1

// An idle board sleeps until the next deadline, because a tick each millisecond would cost 5 % of a core.
#define configUSE_IDLE_HOOK 1
#define configUSE_TICKLESS_IDLE 1
#define portSUPPRESS_TICKS_AND_SLEEP(expected_ticks) kernel_sleep(expected_ticks)

#define configUSE_TICK_HOOK 1            // looks at line and card, in case an interrupt of theirs was missed
#define configCHECK_FOR_STACK_OVERFLOW 0 // these stacks belong to the PC's threads

// Run time in microseconds (kernel.c): the load of the two processors and the shell's `tasks` come from it.
#define configGENERATE_RUN_TIME_STATS 1
#define configRUN_TIME_COUNTER_TYPE uint32_t
#define configUSE_TRACE_FACILITY 1

#define INCLUDE_vTaskDelay 1
#define INCLUDE_vTaskSuspend 1
#define INCLUDE_xTaskDelayUntil 1
#define INCLUDE_xTaskGetIdleTaskHandle 1
#define INCLUDE_xTaskGetCurrentTaskHandle 1
#define INCLUDE_xTaskGetSchedulerState 1
#define INCLUDE_uxTaskGetStackHighWaterMark 1

void kernel_sleep(unsigned long expected_ticks);
_Noreturn void kernel_assert_failed(const char* file, int line);
#define configASSERT(condition)                                                                                        \
    do                                                                                                                 \
    {                                                                                                                  \
        if (!(condition))                                                                                              \
        {                                                                                                              \
            kernel_assert_failed(__FILE__, __LINE__);                                                                  \
        }                                                                                                              \
    } while (0)

#endif

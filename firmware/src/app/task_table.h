/// The board's tasks as data. The tasks that talk to the station (the chapter's figure 19) have the lower priorities,
/// so that sensors and control run on time whatever the station asks for.
#ifndef APP_TASK_TABLE_H
#define APP_TASK_TABLE_H

#include <stdbool.h>
#include <stdint.h>

#include "app/load.h"

typedef enum
{
    task_watch,
    task_sensors,
    task_control,
    task_uart_rx,
    task_uart_tx,
    task_tty,
    task_servos,
    task_fms,
    task_param,
    task_card,
    task_count
} task_id_t;

typedef struct
{
    const char* name;
    uint32_t priority;          ///< higher runs first; 0 is the kernel's idle task
    uint32_t period_ms;         ///< 0: runs when it is woken, or at a period that the station sets
    uint32_t stack_words;       ///< `firmware/README.md` says how they were measured
    uint32_t watchdog_ms;       ///< the board restarts when the task is silent for longer; 0: not watched
    load_processor_t processor; ///< whose load it counts for
} task_row_t;

/// Measurements of a task since the start.
typedef struct
{
    uint32_t late_periods;      ///< periods that began after the next one was due
    uint32_t stack_spare_words; ///< words of its stack that were never used
    bool is_stack_measured;     ///< false where the tasks do not run on the kernel's stacks
} task_health_t;

/// In the order of `task_id_t`.
extern const task_row_t task_table[task_count];

enum
{
    task_stack_words = 5504 ///< of all tasks together
};

_Static_assert((int)task_count <= (int)load_tasks_max, "every task's load is measured");

#endif

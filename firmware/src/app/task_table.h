/// The board's tasks as data. Those of the chapter's figure 19 talk to the station and have the lower priorities, so
/// that sensors and control keep their time whatever the station asks for.
#ifndef APP_TASK_TABLE_H
#define APP_TASK_TABLE_H

#include <stdint.h>

#include "app/load.h"

typedef enum
{
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
    load_processor_t processor; ///< whose load it counts for
} task_row_t;

/// In the order of `task_id_t`.
extern const task_row_t task_table[task_count];

_Static_assert((int)task_count <= (int)load_tasks_max, "every task's load is measured");

#endif

/// The supervisor of the tasks: each task reports regularly that it runs, and a task that has been silent for too long
/// is found. Each task writes only its own entry, so no lock is needed.
#ifndef APP_WATCH_H
#define APP_WATCH_H

#include <stdatomic.h>
#include <stdint.h>

#include "app/task_table.h"

enum
{
    watch_wait_ms = 400 ///< no task waits longer than this between two reports
};

typedef struct
{
    uint32_t patience; ///< factor of the deadlines in the table
    struct
    {
        atomic_uint heard_ms;
        atomic_uint excused_ms; ///< added to the deadline, until the next report
    } tasks[task_count];
} watch_t;

/// Start with every task as if it had reported at `now_ms`. Times are the kernel's and may wrap.
void watch_begin(watch_t* watch, uint32_t patience, uint32_t now_ms);

/// Note that `task` runs.
void watch_hear(watch_t* watch, task_id_t task, uint32_t now_ms);

/// Note that `task` runs and begins something that takes up to `excused_ms` longer than usual.
void watch_excuse(watch_t* watch, task_id_t task, uint32_t excused_ms, uint32_t now_ms);

/// A task that is over its deadline, or `task_count`. A task that never waits keeps those of lower priority from
/// running, so of several the one with the highest priority is returned.
task_id_t watch_find(const watch_t* watch, uint32_t now_ms);

#endif

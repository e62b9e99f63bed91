/// The supervisor of the tasks: each one says that it goes on, and one that has not for too long is found. Each task
/// writes its own entry alone, so no lock is needed.
#ifndef APP_WATCH_H
#define APP_WATCH_H

#include <stdatomic.h>
#include <stdint.h>

#include "app/task_table.h"

enum
{
    watch_wait_ms = 400 ///< no task waits longer before it says so again
};

typedef struct
{
    uint32_t patience; ///< the table's deadlines are that many times longer
    struct
    {
        atomic_uint heard_ms;
        atomic_uint excused_ms; ///< that much longer than usual, this once
    } tasks[task_count];
} watch_t;

/// All tasks are well at `now_ms`. Times are the kernel's and may wrap.
void watch_begin(watch_t* watch, uint32_t patience, uint32_t now_ms);

/// `task` goes on.
void watch_hear(watch_t* watch, task_id_t task, uint32_t now_ms);

/// `task` begins something that takes up to `excused_ms` longer than usual.
void watch_excuse(watch_t* watch, task_id_t task, uint32_t excused_ms, uint32_t now_ms);

/// A task that is over its deadline, or `task_count` when all are well. One that never waits starves those below it, so
/// the first by priority is named.
task_id_t watch_find(const watch_t* watch, uint32_t now_ms);

#endif

#include "app/watch.h"

void watch_begin(watch_t* watch, uint32_t patience, uint32_t now_ms)
{
    watch->patience = patience;
    for (size_t task = 0; task < task_count; task++)
    {
        atomic_store(&watch->tasks[task].excused_ms, 0U);
        atomic_store(&watch->tasks[task].heard_ms, now_ms);
    }
}

void watch_hear(watch_t* watch, task_id_t task, uint32_t now_ms)
{
    watch_excuse(watch, task, 0U, now_ms);
}

void watch_excuse(watch_t* watch, task_id_t task, uint32_t excused_ms, uint32_t now_ms)
{
    atomic_store(&watch->tasks[task].heard_ms, now_ms);
    atomic_store(&watch->tasks[task].excused_ms, excused_ms);
}

task_id_t watch_find(const watch_t* watch, uint32_t now_ms)
{
    for (size_t task = 0; task < task_count; task++)
    {
        const uint32_t allowed_ms =
            task_table[task].watchdog_ms * watch->patience + atomic_load(&watch->tasks[task].excused_ms);
        const uint32_t silent_ms = now_ms - atomic_load(&watch->tasks[task].heard_ms);
        if (task_table[task].watchdog_ms != 0U && silent_ms > allowed_ms)
        {
            return (task_id_t)task;
        }
    }
    return task_count;
}

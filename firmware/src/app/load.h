/// Load of the processors, from the time that each task has run. The deployed board has two processors, one for the
/// sensors and one for control. Here one processor does the work of both, and each task counts for one of the two.
#ifndef APP_LOAD_H
#define APP_LOAD_H

#include <stddef.h>
#include <stdint.h>

typedef enum
{
    load_sensor_dsc,
    load_control_dsc,
    load_processor_count
} load_processor_t;

enum
{
    load_tasks_max = 10
};

typedef struct
{
    load_processor_t processor;
    uint32_t ran_us;    ///< run-time counter at the last update; wraps
    uint32_t per_mille; ///< of the time between the last two updates
} load_task_t;

typedef struct
{
    load_task_t tasks[load_tasks_max];
    uint32_t updated_us;                   ///< wraps
    int16_t percent[load_processor_count]; ///< rounded up, so that a working processor never shows 0
} load_t;

/// Begin to measure: the tasks' run-time counters are `ran_us` at the time `now_us`.
void load_begin(load_t* load, const uint32_t ran_us[load_tasks_max], uint32_t now_us);

/// New shares from the tasks' run-time counters `ran_us` and the time `now_us`. Nothing changes when no time has
/// passed.
void load_update(load_t* load, const uint32_t ran_us[load_tasks_max], uint32_t now_us);

#endif

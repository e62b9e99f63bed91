#include "app/load.h"

void load_begin(load_t* load, const uint32_t ran_us[load_tasks_max], uint32_t now_us)
{
    for (size_t i = 0; i < load_tasks_max; i++)
    {
        load->tasks[i].ran_us = ran_us[i];
    }
    load->updated_us = now_us;
}

void load_update(load_t* load, const uint32_t ran_us[load_tasks_max], uint32_t now_us)
{
    const uint32_t elapsed_us = now_us - load->updated_us;
    if (elapsed_us == 0U)
    {
        return;
    }
    uint64_t busy_us[load_processor_count] = {0};
    for (size_t i = 0; i < load_tasks_max; i++)
    {
        load_task_t* const task = &load->tasks[i];
        const uint64_t share_us = ran_us[i] - task->ran_us;
        task->ran_us = ran_us[i];
        task->per_mille = (uint32_t)(share_us * 1000U / elapsed_us);
        busy_us[task->processor] += share_us;
    }
    for (size_t i = 0; i < load_processor_count; i++)
    {
        const uint64_t percent = (busy_us[i] * 100U + elapsed_us - 1U) / elapsed_us;
        load->percent[i] = (int16_t)(percent < 100U ? percent : 100U);
    }
    load->updated_us = now_us;
}

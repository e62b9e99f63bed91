#include "app/application_state.h"

#include <string.h>

#include "hal/time.h"

void application_lock(application_t* app)
{
    (void)xSemaphoreTake(app->board_mutex, portMAX_DELAY);
}

void application_unlock(application_t* app)
{
    (void)xSemaphoreGive(app->board_mutex);
}

TickType_t application_ticks(uint32_t duration_ms)
{
    return pdMS_TO_TICKS((TickType_t)duration_ms);
}

uint32_t application_now_ms(const application_t* app)
{
    return time_ms() - app->started_ms;
}

uint32_t application_kernel_ms(void)
{
    return (uint32_t)xTaskGetTickCount() * (uint32_t)portTICK_PERIOD_MS;
}

void application_hear(application_t* app, task_id_t task)
{
    const uint32_t now_ms = application_kernel_ms();
    const char* const hangs = app->hardware.hang_task;
    while (hangs != NULL && now_ms > 1000U && strcmp(hangs, task_table[task].name) == 0)
    {
        // Hang here for ever, to test the watchdog.
    }
    watch_hear(&app->watch, task, now_ms);
}

void application_wait(TickType_t ticks)
{
    const TickType_t longest = application_ticks(watch_wait_ms);
    (void)ulTaskNotifyTake(pdTRUE, ticks < longest ? ticks : longest);
}

#include "app/application_state.h"

#include "hal/time.h"

/// Words of each task's stack; `firmware/README.md` says how it was measured.
enum
{
    stack_words = 512
};

void application_lock(application_t* app)
{
    (void)xSemaphoreTake(app->board_mutex, portMAX_DELAY);
}

void application_unlock(application_t* app)
{
    (void)xSemaphoreGive(app->board_mutex);
}

uint32_t application_now_ms(const application_t* app)
{
    return time_ms() - app->started_ms;
}

/// A frame of the board, or nothing of it when the line is too slow for it.
static void send_frame(void* context, const uint8_t* frame, size_t size)
{
    application_t* const app = context;
    (void)mailbox_put(&app->transmitted, frame, size);
}

static storage_status_t read_card(void* context, const char* name, uint8_t* data, size_t capacity, size_t* size)
{
    const storage_t* const card = ((application_t*)context)->hardware.storage;
    return card->read(card->context, name, data, capacity, size);
}

/// A card takes its time to write. The task that stores waits for it, but sensors, control and streams must not: they
/// get the board meanwhile. Only ttyTask changes parameters, so what is being stored stays as it is.
static storage_status_t replace_on_card(void* context, const char* name, const uint8_t* data, size_t size)
{
    application_t* const app = context;
    const storage_t* const card = app->hardware.storage;
    application_unlock(app);
    const storage_status_t status = card->replace(card->context, name, data, size);
    application_lock(app);
    return status;
}

void application_reset(application_t* app)
{
    const board_config_t config = {
        .legacy = app->hardware.legacy,
        .hil_period_s = (float)app->hardware.hil_period_ms / 1000.0F,
        .storage = app->hardware.storage == NULL ? NULL : &app->storage,
        .send = send_frame,
        .send_context = app,
    };
    app->started_ms = time_ms();
    board_init(&app->board, &config);
    app->shell = (shell_t){
        .board = &app->board,
        .sensors = &app->hardware.sensors,
        .load = &app->load,
        .frames_dropped = &app->transmitted.refused,
    };
    tty_init(&app->tty, &app->shell, app->reply, sizeof app->reply);
}

/// Bytes came in: UartRxTask fetches them.
static bool on_receive_interrupt(void* context)
{
    const application_t* const app = context;
    BaseType_t woken = pdFALSE;
    vTaskNotifyGiveFromISR(app->handles[task_uart_rx], &woken);
    return woken != pdFALSE;
}

_Noreturn void application_run(const application_hardware_t* hardware)
{
    static application_t application;
    static StaticTask_t tasks[task_count];
    static StackType_t stacks[task_count][stack_words];

    application_t* const app = &application;
    app->hardware = *hardware;
    app->storage = (storage_t){.context = app, .read = read_card, .replace = replace_on_card};
    app->board_mutex = xSemaphoreCreateMutexStatic(&app->board_mutex_memory);
    mailbox_init(&app->received);
    mailbox_init(&app->transmitted);
    application_reset(app);
    for (size_t i = 0; i < task_count; i++)
    {
        app->load.tasks[i].processor = task_table[i].processor;
        app->handles[i] = xTaskCreateStatic(task_bodies[i], task_table[i].name, stack_words, app,
                                            task_table[i].priority, stacks[i], &tasks[i]);
    }
    app->received.reader = app->handles[task_tty];
    app->transmitted.reader = app->handles[task_uart_tx];
    app->hardware.uart.on_receive(app->hardware.uart.context, on_receive_interrupt, app);
    vTaskStartScheduler();
    for (;;)
    {
        // The scheduler comes back only when it cannot start, which static memory rules out.
        configASSERT(false);
    }
}

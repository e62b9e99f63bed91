#include "app/application_state.h"

#include <string.h>

#include "flight/board_card.h"
#include "flight/board_reports.h"
#include "flight/gains.h"
#include "hal/time.h"
#include "records/parameter_record.h"

enum
{
    slowest_card_ms = 30000 ///< one that is wearing out, or a PC's folder on a busy disk
};

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

static uint32_t kernel_ms(void)
{
    return (uint32_t)xTaskGetTickCount() * (uint32_t)portTICK_PERIOD_MS;
}

void application_hear(application_t* app, task_id_t task)
{
    const uint32_t now_ms = kernel_ms();
    const char* const hangs = app->hardware.hang_task;
    while (hangs != NULL && now_ms > 1000U && strcmp(hangs, task_table[task].name) == 0)
    {
        // What the watchdog is there for.
    }
    watch_hear(&app->watch, task, now_ms);
}

void application_wait(TickType_t ticks)
{
    const TickType_t longest = application_ticks(watch_wait_ms);
    (void)ulTaskNotifyTake(pdTRUE, ticks < longest ? ticks : longest);
}

/// The card takes its time, and the calling task waits for it.
static void take_card(application_t* app)
{
    const TaskHandle_t caller = xTaskGetCurrentTaskHandle();
    for (size_t task = 0; task < task_count; task++)
    {
        if (app->handles[task] == caller && caller != NULL)
        {
            watch_excuse(&app->watch, (task_id_t)task, slowest_card_ms, kernel_ms());
        }
    }
    (void)xSemaphoreTake(app->card_mutex, portMAX_DELAY);
}

/// A frame of the board, or nothing of it when the line is too slow for it.
static void send_frame(void* context, const uint8_t* frame, size_t size)
{
    application_t* const app = context;
    (void)mailbox_put(&app->transmitted, frame, size);
}

/// The station hears when the card's alarm comes or goes, where it asked for extensions.
static void note_card(application_t* app, board_keeps_t what, record_state_t state)
{
    application_lock(app);
    const bool is_news = board_card_note(&app->board, what, state);
    if (is_news && app->board.extended && app->tty.mode == tty_binary)
    {
        board_report_capabilities(&app->board, application_now_ms(app));
    }
    application_unlock(app);
}

/// A card takes its time to write, and nobody else may have to wait for it: the board is locked only to copy.
bool application_store(application_t* app, board_keeps_t what)
{
    bool done = false;
    take_card(app);
    if (app->hardware.storage != NULL)
    {
        application_lock(app);
        const size_t taken = board_card_take(&app->board, what);
        application_unlock(app);
        const record_state_t state = board_card_write(&app->board, what, taken);
        note_card(app, what, state);
        done = state == record_whole;
    }
    (void)xSemaphoreGive(app->card_mutex);
    return done;
}

static board_keeps_t next_plan(application_t* app)
{
    application_lock(app);
    const board_keeps_t next = board_card_next(&app->board);
    application_unlock(app);
    return next;
}

void application_store_plans(application_t* app)
{
    for (board_keeps_t next = next_plan(app); next != board_keeps_count; next = next_plan(app))
    {
        // Whoever waits for it hears of a failure by the card's alarm.
        (void)application_store(app, next);
    }
}

bool application_load(application_t* app)
{
    parameters_t parameters;
    record_state_t state = record_absent;
    take_card(app);
    if (app->hardware.storage != NULL)
    {
        state = board_card_read_parameters(&app->board, &parameters);
        note_card(app, board_keeps_parameters, state);
    }
    (void)xSemaphoreGive(app->card_mutex);
    if (state == record_whole)
    {
        application_lock(app);
        app->board.parameters = parameters;
        app->board.gains = gains_of(&parameters);
        application_unlock(app);
    }
    return state == record_whole;
}

void application_reset(application_t* app, bool may_be_in_flight)
{
    // What was uploaded and acknowledged outlives a reset.
    application_store_plans(app);
    // The card first, then the board, as everywhere.
    take_card(app);
    const storage_t* const storage = app->hardware.storage;
    // One that does not answer keeps its caller waiting: not while everybody waits for the board.
    const bool is_silent = storage != NULL && !parameter_record_card_answers(storage);
    application_lock(app);
    const board_config_t config = {
        .legacy = app->hardware.legacy,
        .may_be_in_flight = may_be_in_flight,
        .hil_period_s = (float)app->hardware.hil_period_ms / 1000.0F,
        .storage = storage,
        .card_is_silent = is_silent,
        .send = send_frame,
        .send_context = app,
    };
    app->started_ms = time_ms();
    board_init(&app->board, &config);
    app->shell = (shell_t){
        .board = &app->board,
        .sensors = &app->hardware.sensors,
        .load = &app->load,
        .health = app->health,
        .restart_reason = app->hardware.restart_reason,
        .frames_dropped = &app->transmitted.refused,
    };
    tty_init(&app->tty, &app->shell, app->reply, sizeof app->reply);
    shell_greet(&app->board, &app->tty.reply);
    application_unlock(app);
    (void)xSemaphoreGive(app->card_mutex);
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
    static StackType_t stacks[task_stack_words];

    application_t* const app = &application;
    app->hardware = *hardware;
    app->board_mutex = xSemaphoreCreateMutexStatic(&app->board_mutex_memory);
    app->card_mutex = xSemaphoreCreateMutexStatic(&app->card_mutex_memory);
    mailbox_init(&app->received);
    mailbox_init(&app->transmitted);
    application_reset(app, app->hardware.restart_reason != NULL);
    watch_begin(&app->watch, app->hardware.watchdog.patience, kernel_ms());
    size_t used_words = 0;
    for (size_t i = 0; i < task_count; i++)
    {
        app->load.tasks[i].processor = task_table[i].processor;
        configASSERT(used_words + task_table[i].stack_words <= task_stack_words);
        app->handles[i] = xTaskCreateStatic(task_bodies[i], task_table[i].name, task_table[i].stack_words, app,
                                            task_table[i].priority, stacks + used_words, &tasks[i]);
        used_words += task_table[i].stack_words;
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

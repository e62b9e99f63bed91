#include "app/application_card.h"

#include "flight/board_streams.h"
#include "flight/own_gains.h"

enum
{
    slowest_card_ms = 30000 ///< a card that is wearing out, or a PC's folder on a busy disk
};

void application_take_card(application_t* app)
{
    const TaskHandle_t caller = xTaskGetCurrentTaskHandle();
    for (size_t task = 0; task < task_count; task++)
    {
        if (app->handles[task] == caller && caller != NULL)
        {
            watch_excuse(&app->watch, (task_id_t)task, slowest_card_ms, application_kernel_ms());
        }
    }
    (void)xSemaphoreTake(app->card_mutex, portMAX_DELAY);
}

void application_give_card(application_t* app)
{
    (void)xSemaphoreGive(app->card_mutex);
}

/// Remember the result; tell a station that knows extensions when the card's alarm came or went by it.
static void note_card(application_t* app, board_keeps_t what, record_state_t state)
{
    application_lock(app);
    const bool is_news = board_card_note(&app->board.card, what, state);
    if (is_news && app->board.station.is_extended && app->tty.mode == tty_binary)
    {
        board_send_capabilities(&app->board, application_now_ms(app));
    }
    application_unlock(app);
}

/// Writing to a card takes long, and the other tasks must not wait for it: the board is locked only while copying.
static bool store(application_t* app, board_keeps_t what)
{
    bool done = false;
    application_take_card(app);
    if (app->hardware.storage != NULL)
    {
        application_lock(app);
        const size_t taken = board_card_take(&app->board.card, what, &app->board.tuning, &app->board.plans);
        application_unlock(app);
        const record_state_t state = board_card_write(&app->board.card, what, taken);
        note_card(app, what, state);
        done = state == record_whole;
    }
    application_give_card(app);
    return done;
}

bool application_store_tuning(application_t* app)
{
    const bool has_parameters = store(app, board_keeps_parameters);
    // a deployed board has no gains of its own
    const bool has_gains = app->hardware.legacy || store(app, board_keeps_own_gains);
    return has_parameters && has_gains;
}

static board_keeps_t next_plan(application_t* app)
{
    application_lock(app);
    const board_keeps_t next = board_card_next(&app->board.plans);
    application_unlock(app);
    return next;
}

void application_store_plans(application_t* app)
{
    for (board_keeps_t next = next_plan(app); next != board_keeps_count; next = next_plan(app))
    {
        // A failure raises the card's alarm.
        (void)store(app, next);
    }
}

bool application_load(application_t* app)
{
    parameters_t parameters;
    tuning_t others;
    record_state_t state = record_absent;
    record_state_t gains = record_absent;
    tuning_init(&others);
    application_take_card(app);
    if (app->hardware.storage != NULL)
    {
        state = board_card_read_parameters(&app->board.card, &parameters);
        note_card(app, board_keeps_parameters, state);
    }
    if (app->hardware.storage != NULL && !app->hardware.legacy)
    {
        gains = board_card_read_own_gains(&app->board.card, &others);
        note_card(app, board_keeps_own_gains, gains);
    }
    application_give_card(app);
    application_lock(app);
    if (state == record_whole)
    {
        tuning_replace(&app->board.tuning, &parameters);
    }
    if (gains == record_whole)
    {
        own_gains_copy(&app->board.tuning, &others);
    }
    application_unlock(app);
    return state == record_whole;
}

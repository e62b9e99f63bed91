#include "app/application_reset.h"

#include "app/application_card.h"
#include "app/shell_reports.h"
#include "hal/time.h"
#include "records/parameter_record.h"

/// A frame of the board, or nothing of it when the line is too slow for it.
static void send_frame(void* context, const uint8_t* frame, size_t size)
{
    application_t* const app = context;
    (void)mailbox_put(&app->transmitted, frame, size);
}

void application_reset(application_t* app, bool may_be_in_flight)
{
    // What was uploaded and acknowledged outlives a reset.
    application_store_plans(app);
    // The card first, then the board, as everywhere.
    application_take_card(app);
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
    shell_greet(&app->board.card, &app->tty.reply);
    application_unlock(app);
    application_give_card(app);
}

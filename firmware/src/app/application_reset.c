#include "app/application_reset.h"

#include "app/application_card.h"
#include "app/shell_reports.h"
#include "hal/time.h"
#include "records/parameter_record.h"

/// Send a frame of the board; drop it as a whole when the line is too slow.
static void send_frame(void* context, const uint8_t* frame, size_t size)
{
    application_t* const app = context;
    (void)mailbox_put(&app->transmitted, frame, size);
}

static bool line_is_idle(const void* context)
{
    const application_t* const app = context;
    return mailbox_is_all_but_empty(&app->transmitted);
}

void application_reset(application_t* app, bool may_be_in_flight)
{
    // An uploaded and acknowledged plan must survive the reset.
    application_store_plans(app);
    // Lock the card first, then the board, as everywhere, so that no two tasks block each other.
    application_take_card(app);
    const storage_t* const storage = app->hardware.storage;
    // A card that does not answer blocks its caller for long, so ask it before the board is locked.
    const bool is_silent = storage != NULL && !parameter_record_card_answers(storage);
    application_lock(app);
    const board_config_t config = {
        .legacy = app->hardware.legacy,
        .may_be_in_flight = may_be_in_flight,
        .hil_period_s = (float)app->hardware.hil_period_ms / 1000.0F,
        .storage = storage,
        .card_is_silent = is_silent,
        .send = send_frame,
        .is_idle = line_is_idle,
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

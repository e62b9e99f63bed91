#include "app/task_line.h"

#include <string.h>

#include "app/application_card.h"
#include "app/application_reset.h"
#include "app/application_state.h"
#include "app/shell_reply.h"

enum
{
    piece_bytes = 64, ///< moved at a time; several times the receiver's FIFO threshold of 8
    reply_piece_bytes = 512
};

/// Woken by the line's interrupt; moves received bytes into the receive mailbox. When that is full, they stay in the
/// line's buffer until ttyTask has caught up.
void run_uart_rx(void* context)
{
    application_t* const app = context;
    const uart_t* const uart = &app->hardware.uart;
    for (;;)
    {
        uint8_t bytes[piece_bytes];
        bool has_more = true;
        while (has_more && byte_ring_room(&app->received.ring) >= sizeof bytes)
        {
            const size_t size = uart->read(uart->context, bytes, sizeof bytes);
            has_more = size > 0U;
            if (has_more)
            {
                (void)mailbox_put(&app->received, bytes, size);
            }
        }
        const bool is_full = byte_ring_room(&app->received.ring) < sizeof bytes;
        application_hear(app, task_uart_rx);
        application_wait(is_full ? 1 : portMAX_DELAY);
    }
}

/// Moves the transmit mailbox to the line, as fast as the line takes it.
void run_uart_tx(void* context)
{
    application_t* const app = context;
    const uart_t* const uart = &app->hardware.uart;
    for (;;)
    {
        const uint8_t* bytes = NULL;
        const size_t size = byte_ring_peek(&app->transmitted.ring, &bytes);
        const size_t sent = size > 0 ? uart->write(uart->context, bytes, size) : 0;
        byte_ring_skip(&app->transmitted.ring, sent);
        application_hear(app, task_uart_tx);
        if (size == 0)
        {
            application_wait(portMAX_DELAY);
        }
        else if (sent < size)
        {
            vTaskDelay(1); // the line is full
        }
    }
}

/// Send the answer of the shell or the AHRS test. Wait only briefly for room, because a terminal that does not read
/// must not stop the board.
static void send_reply(application_t* app)
{
    text_t* const reply = &app->tty.reply;
    for (size_t at = 0; at < reply->size; at += reply_piece_bytes)
    {
        const size_t rest = reply->size - at;
        const size_t size = rest < reply_piece_bytes ? rest : (size_t)reply_piece_bytes;
        for (int waited_ms = 0; byte_ring_room(&app->transmitted.ring) < size && waited_ms < 100; waited_ms++)
        {
            vTaskDelay(application_ticks(1));
        }
        application_hear(app, task_tty);
        (void)mailbox_put(&app->transmitted, (const uint8_t*)reply->bytes + at, size);
    }
    reply->size = 0;
}

/// Do what the interpreter asked for.
static void do_request(application_t* app, shell_request_t request)
{
    switch (request)
    {
    case shell_asks_nothing:
        break;
    case shell_asks_reset:
        application_reset(app, false);
        break;
    case shell_asks_load:
        shell_tell_loaded(&app->tty.reply, application_load(app));
        break;
    case shell_asks_store:
        shell_tell_stored(&app->tty.reply, application_store_tuning(app));
        break;
    case shell_asks_store_acknowledged:
        application_lock(app);
        app->stores_asked++;
        application_unlock(app);
        (void)xTaskNotifyGive(app->handles[task_card]);
        break;
    case shell_asks_store_plans:
        (void)xTaskNotifyGive(app->handles[task_card]);
        break;
    }
    send_reply(app);
}

/// Wake the tasks whose period may have changed, so that they do not wait for the end of a long old one.
static void announce_periods(application_t* app)
{
    for (size_t i = task_servos; i <= task_param; i++)
    {
        (void)xTaskNotifyGive(app->handles[i]);
    }
}

/// Give received bytes to the interpreter, which runs the HIL laws too. Do what it asks for at once; then let it
/// continue with the bytes that it still holds.
static void interpret(application_t* app, const uint8_t* bytes, size_t size)
{
    size_t taken = 0;
    shell_request_t request = shell_asks_nothing;
    do
    {
        application_lock(app);
        const telemetry_schedule_t before = app->board.schedule;
        taken += tty_receive(&app->tty, bytes + taken, size - taken, application_now_ms(app));
        const bool is_repaced = memcmp(before.period_ms, app->board.schedule.period_ms, sizeof before.period_ms) != 0;
        request = app->shell.request;
        app->shell.request = shell_asks_nothing;
        application_unlock(app);
        send_reply(app);
        do_request(app, request);
        if (is_repaced || request == shell_asks_reset)
        {
            announce_periods(app);
        }
    } while (taken < size || request != shell_asks_nothing);
}

/// Do what is due by the clock, among it a command that was found after a false header.
static void tick(application_t* app)
{
    static const uint8_t nothing[1] = {0};
    application_lock(app);
    tty_tick(&app->tty, application_now_ms(app));
    application_unlock(app);
    send_reply(app);
    if (app->shell.request != shell_asks_nothing)
    {
        interpret(app, nothing, 0);
    }
}

void run_tty(void* context)
{
    application_t* const app = context;
    uint32_t ticked_ms = application_now_ms(app);
    send_reply(app); // the greeting
    for (;;)
    {
        application_hear(app, task_tty);
        uint8_t bytes[piece_bytes];
        const size_t size = byte_ring_take(&app->received.ring, bytes, sizeof bytes);
        if (size > 0)
        {
            interpret(app, bytes, size);
        }
        const uint32_t wait_ms = tty_wait_ms(&app->tty);
        const uint32_t elapsed_ms = application_now_ms(app) - ticked_ms;
        if (wait_ms != UINT32_MAX && elapsed_ms >= wait_ms)
        {
            ticked_ms += elapsed_ms;
            tick(app);
        }
        else if (size == 0)
        {
            application_wait(wait_ms == UINT32_MAX ? portMAX_DELAY : application_ticks(wait_ms - elapsed_ms));
        }
    }
}

/// Take one request of the station to store its parameters; false when there is none.
static bool take_store(application_t* app)
{
    application_lock(app);
    const bool is_asked = app->stores_asked > 0U;
    app->stores_asked -= is_asked ? 1U : 0U;
    application_unlock(app);
    return is_asked;
}

/// Stores uploaded plans, and the parameters when the station asks for it, which is acknowledged once they are on the
/// card; HIL continues meanwhile. A plan uploaded before that request is on the card by then, too.
void run_card(void* context)
{
    application_t* const app = context;
    for (;;)
    {
        application_hear(app, task_card);
        application_wait(portMAX_DELAY);
        application_store_plans(app);
        while (take_store(app))
        {
            const bool done = application_store_tuning(app);
            application_lock(app);
            if (app->board.station.is_extended && app->tty.mode == tty_binary)
            {
                report_acknowledgement(&app->board.line, COMMAND_STORE_PARAMETERS_ID,
                                       done ? command_done : command_storage_failed);
            }
            application_unlock(app);
            application_store_plans(app);
        }
    }
}

#include <string.h>

#include "app/application_state.h"
#include "flight/board_reports.h"

enum
{
    load_period_us = 1000000,
    piece_bytes = 64, ///< moved at a time; a receiver's FIFO threshold of 8 fits several times
    reply_piece_bytes = 512
};

static TickType_t ticks_of(uint32_t time)
{
    return pdMS_TO_TICKS((TickType_t)time);
}

static float period_s(task_id_t task)
{
    return (float)task_table[task].period_ms / 1000.0F;
}

/// Reads every sensor and gives the readings to the board. Models of sensors are told what the simulator says first.
static void run_sensors(void* context)
{
    application_t* const app = context;
    const sensors_t* const sensors = &app->hardware.sensors;
    TickType_t woken = xTaskGetTickCount();
    uint32_t observed = 0;
    for (;;)
    {
        application_lock(app);
        const uint32_t count = app->board.xplane_info_count;
        const command_xplane_info_t info = app->board.xplane_info;
        const float throttle = app->board.loops[board_plan_hil].surfaces.throttle;
        application_unlock(app);

        if (count != observed && sensors->observe != NULL && count != 0U)
        {
            sensors->observe(sensors->context, &info, throttle);
        }
        observed = count;
        sensors_reading_t reading;
        sensors->read(sensors->context, period_s(task_sensors), &reading);

        application_lock(app);
        app->board.sensors.ahrs = reading.ahrs;
        app->board.sensors.inertial = reading.inertial;
        app->board.sensors.analog = reading.analog;
        app->board.sensors.gps = reading.gps;
        app->board.sensors.servos_in = reading.receiver;
        application_unlock(app);
        (void)xTaskDelayUntil(&woken, ticks_of(task_table[task_sensors].period_ms));
    }
}

/// The real aircraft's loop: sensors and receiver to servos.
static void run_control(void* context)
{
    application_t* const app = context;
    TickType_t woken = xTaskGetTickCount();
    for (;;)
    {
        (void)xTaskDelayUntil(&woken, ticks_of(task_table[task_control].period_ms));
        float positions[board_servo_count];
        application_lock(app);
        board_flight_step(&app->board, period_s(task_control));
        board_servo_positions(&app->board, positions);
        application_unlock(app);
        app->hardware.servos.write(app->hardware.servos.context, positions, board_servo_count);
    }
}

/// Woken by the line's interrupt; moves what it holds into the receive mailbox. When that is full the bytes stay where
/// they are until ttyTask has caught up.
static void run_uart_rx(void* context)
{
    application_t* const app = context;
    const uart_t* const uart = &app->hardware.uart;
    for (;;)
    {
        uint8_t bytes[piece_bytes];
        size_t size = 0;
        while (byte_ring_room(&app->received.ring) >= sizeof bytes &&
               (size = uart->read(uart->context, bytes, sizeof bytes)) > 0)
        {
            (void)mailbox_put(&app->received, bytes, size);
        }
        const bool is_full = byte_ring_room(&app->received.ring) < sizeof bytes;
        (void)ulTaskNotifyTake(pdTRUE, is_full ? 1 : portMAX_DELAY);
    }
}

/// Hands the transmit mailbox to the line, at the line's own pace.
static void run_uart_tx(void* context)
{
    application_t* const app = context;
    const uart_t* const uart = &app->hardware.uart;
    for (;;)
    {
        const uint8_t* bytes = NULL;
        const size_t size = byte_ring_peek(&app->transmitted.ring, &bytes);
        const size_t sent = size > 0 ? uart->write(uart->context, bytes, size) : 0;
        byte_ring_skip(&app->transmitted.ring, sent);
        if (size == 0)
        {
            (void)ulTaskNotifyTake(pdTRUE, portMAX_DELAY);
        }
        else if (sent < size)
        {
            vTaskDelay(1); // the line is full
        }
    }
}

/// Send what the shell or the AHRS test answered, waiting for room a little: a person's terminal that does not read
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
            vTaskDelay(ticks_of(1));
        }
        (void)mailbox_put(&app->transmitted, (const uint8_t*)reply->bytes + at, size);
    }
    reply->size = 0;
}

/// What the interpreter asked for.
static void fulfil(application_t* app, shell_request_t request)
{
    switch (request)
    {
    case shell_asks_nothing:
        break;
    case shell_asks_reset:
        application_reset(app);
        break;
    case shell_asks_load:
        shell_tell_loaded(&app->tty.reply, application_load(app));
        break;
    case shell_asks_store:
        shell_tell_stored(&app->tty.reply, application_store(app));
        break;
    case shell_asks_store_acknowledged:
        (void)xTaskNotifyGive(app->handles[task_card]);
        break;
    }
    send_reply(app);
}

/// Tasks in the middle of a long period hear that it has changed.
static void announce_periods(application_t* app)
{
    for (size_t i = task_servos; i <= task_param; i++)
    {
        (void)xTaskNotifyGive(app->handles[i]);
    }
}

/// Received bytes through the interpreter, which runs the HIL laws too. What it asks for is done at once; then it goes
/// on with what it still holds.
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
        fulfil(app, request);
        if (is_repaced || request == shell_asks_reset)
        {
            announce_periods(app);
        }
    } while (taken < size || request != shell_asks_nothing);
}

/// What happens by the clock; a command found behind a false header too.
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

static void run_tty(void* context)
{
    application_t* const app = context;
    uint32_t ticked_ms = application_now_ms(app);
    for (;;)
    {
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
            (void)ulTaskNotifyTake(pdTRUE, wait_ms == UINT32_MAX ? portMAX_DELAY : ticks_of(wait_ms - elapsed_ms));
        }
    }
}

/// Stores the parameters for the station, which gets its answer when they are there; HIL goes on meanwhile.
static void run_card(void* context)
{
    application_t* const app = context;
    for (;;)
    {
        (void)ulTaskNotifyTake(pdFALSE, portMAX_DELAY);
        const command_result_t result = application_store(app) ? command_done : command_storage_failed;
        application_lock(app);
        if (app->board.extended && app->tty.mode == tty_binary)
        {
            board_report_acknowledgement(&app->board, COMMAND_STORE_PARAMETERS_ID, result);
        }
        application_unlock(app);
    }
}

/// Wait for the end of the period that began at `*begun`, which the station may change meanwhile.
static void wait_for_period(application_t* app, telemetry_task_t task, TickType_t* begun)
{
    for (;;)
    {
        application_lock(app);
        const TickType_t period = ticks_of(app->board.schedule.period_ms[task]);
        application_unlock(app);
        const TickType_t elapsed = xTaskGetTickCount() - *begun;
        if (elapsed >= period)
        {
            // Far behind, the next period begins now: nobody wants the missed ones in one go.
            *begun += elapsed >= 2 * period ? elapsed : period;
            return;
        }
        (void)ulTaskNotifyTake(pdTRUE, period - elapsed);
    }
}

static void send_streams(application_t* app, telemetry_task_t task)
{
    application_lock(app);
    if (app->tty.mode == tty_binary)
    {
        board_send_streams(&app->board, task);
    }
    application_unlock(app);
}

static void run_servos(void* context)
{
    TickType_t begun = xTaskGetTickCount();
    for (;;)
    {
        wait_for_period(context, telemetry_task_servos, &begun);
        send_streams(context, telemetry_task_servos);
    }
}

static void read_run_times(const application_t* app, uint32_t ran_us[load_tasks_max])
{
    for (size_t i = 0; i < load_tasks_max; i++)
    {
        ran_us[i] = i < task_count ? ulTaskGetRunTimeCounter(app->handles[i]) : 0U;
    }
}

static void refresh_load(application_t* app)
{
    const uint32_t now_us = portGET_RUN_TIME_COUNTER_VALUE();
    if (now_us - app->load.updated_us < load_period_us)
    {
        return;
    }
    uint32_t ran_us[load_tasks_max];
    read_run_times(app, ran_us);
    application_lock(app);
    load_update(&app->load, ran_us, now_us);
    app->board.sensors.statistics.sensor_dsc_percent = app->load.percent[load_sensor_dsc];
    app->board.sensors.statistics.control_dsc_percent = app->load.percent[load_control_dsc];
    application_unlock(app);
}

static void run_fms(void* context)
{
    application_t* const app = context;
    TickType_t begun = xTaskGetTickCount();
    uint32_t ran_us[load_tasks_max];
    read_run_times(app, ran_us);
    load_begin(&app->load, ran_us, portGET_RUN_TIME_COUNTER_VALUE());
    for (;;)
    {
        wait_for_period(app, telemetry_task_fms, &begun);
        refresh_load(app);
        send_streams(app, telemetry_task_fms);
    }
}

static void run_param(void* context)
{
    TickType_t begun = xTaskGetTickCount();
    for (;;)
    {
        wait_for_period(context, telemetry_task_param, &begun);
        send_streams(context, telemetry_task_param);
    }
}

void (*const task_bodies[task_count])(void* application) = {
    [task_sensors] = run_sensors, [task_control] = run_control, [task_uart_rx] = run_uart_rx,
    [task_uart_tx] = run_uart_tx, [task_tty] = run_tty,         [task_servos] = run_servos,
    [task_fms] = run_fms,         [task_param] = run_param,     [task_card] = run_card,
};

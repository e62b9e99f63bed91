#include "app/task_bodies.h"

#include "app/application_state.h"
#include "app/sensing.h"
#include "app/task_line.h"

enum
{
    load_period_us = 1000000
};

static float period_s(task_id_t task)
{
    return (float)task_table[task].period_ms / 1000.0F;
}

/// Finds a task that hangs, and restarts the board then. The port's watchdog notices when this task itself hangs.
static void run_watch(void* context)
{
    application_t* const app = context;
    const watchdog_t* const watchdog = &app->hardware.watchdog;
    TickType_t woken = xTaskGetTickCount();
    for (;;)
    {
        watchdog->feed(watchdog->context);
        (void)xTaskDelayUntil(&woken, application_ticks(task_table[task_watch].period_ms));
        const task_id_t hanging = watch_find(&app->watch, (uint32_t)xTaskGetTickCount() * (uint32_t)portTICK_PERIOD_MS);
        if (hanging != task_count)
        {
            watchdog->give_up(watchdog->context, task_table[hanging].name);
        }
    }
}

/// Wait for the next period of a task that has a fixed one.
static void wait_for_next(application_t* app, task_id_t task, TickType_t* woken)
{
    application_hear(app, task);
    if (xTaskDelayUntil(woken, application_ticks(task_table[task].period_ms)) == pdFALSE)
    {
        app->health[task].late_periods++;
    }
}

/// Reads every sensor and gives the board the estimate. Before that, models of sensors get the newest simulator
/// information.
static void run_sensors(void* context)
{
    application_t* const app = context;
    const sensors_t* const sensors = &app->hardware.sensors;
    TickType_t woken = xTaskGetTickCount();
    uint32_t observed = 0;
    estimator_t estimator;
    estimator_init(&estimator);
    for (;;)
    {
        application_lock(app);
        const uint32_t count = app->board.hil.accepted;
        const command_xplane_info_t info = app->board.hil.newest;
        const float throttle = app->board.hil.loop.surfaces.throttle;
        application_unlock(app);

        if (count != observed && sensors->observe != NULL && count != 0U)
        {
            sensors->observe(sensors->context, &info, throttle);
        }
        observed = count;
        sensors_reading_t reading;
        sensors->read(sensors->context, period_s(task_sensors), &reading);

        application_lock(app);
        sensing_update(&estimator, &reading, period_s(task_sensors), &app->board.measured.sensors);
        (void)measurements_hear_receiver(&app->board.measured);
        application_unlock(app);
        wait_for_next(app, task_sensors, &woken);
    }
}

/// Runs the real aircraft's loop, from sensors and receiver to servos.
static void run_control(void* context)
{
    application_t* const app = context;
    TickType_t woken = xTaskGetTickCount();
    for (;;)
    {
        wait_for_next(app, task_control, &woken);
        float positions[board_servo_count];
        application_lock(app);
        board_supervise_hil(&app->board, application_now_ms(app));
        board_flight_step(&app->board, period_s(task_control));
        board_servo_positions(&app->board, positions);
        application_unlock(app);
        app->hardware.servos.write(app->hardware.servos.context, positions, board_servo_count);
    }
}

/// Wait for the end of the period that began at `*begun`, which the station may change meanwhile.
static void wait_for_period(application_t* app, telemetry_task_t task, task_id_t self, TickType_t* begun)
{
    for (;;)
    {
        application_hear(app, self);
        application_lock(app);
        const TickType_t period = application_ticks(app->board.schedule.period_ms[task]);
        application_unlock(app);
        const TickType_t elapsed = xTaskGetTickCount() - *begun;
        if (elapsed >= period)
        {
            // Far behind, the next period begins now, so that the missed ones are not made up for in a burst.
            *begun += elapsed >= 2 * period ? elapsed : period;
            return;
        }
        application_wait(period - elapsed);
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
        wait_for_period(context, telemetry_task_servos, task_servos, &begun);
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

static void refresh_stacks(application_t* app)
{
    for (size_t i = 0; app->hardware.measures_stacks && i < task_count; i++)
    {
        app->health[i].stack_spare_words = (uint32_t)uxTaskGetStackHighWaterMark(app->handles[i]);
        app->health[i].is_stack_measured = true;
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
    refresh_stacks(app);
    load_update(&app->load, ran_us, now_us);
    app->board.measured.sensors.statistics.sensor_dsc_percent = app->load.percent[load_sensor_dsc];
    app->board.measured.sensors.statistics.control_dsc_percent = app->load.percent[load_control_dsc];
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
        wait_for_period(app, telemetry_task_fms, task_fms, &begun);
        refresh_load(app);
        send_streams(app, telemetry_task_fms);
    }
}

static void run_param(void* context)
{
    TickType_t begun = xTaskGetTickCount();
    for (;;)
    {
        wait_for_period(context, telemetry_task_param, task_param, &begun);
        send_streams(context, telemetry_task_param);
    }
}

void (*const task_bodies[task_count])(void* application) = {
    [task_watch] = run_watch,     [task_sensors] = run_sensors, [task_control] = run_control,
    [task_uart_rx] = run_uart_rx, [task_uart_tx] = run_uart_tx, [task_tty] = run_tty,
    [task_servos] = run_servos,   [task_fms] = run_fms,         [task_param] = run_param,
    [task_card] = run_card,
};

#include "comms/telemetry.h"

#include <stddef.h>
#include <string.h>

#include "comms/protocol_gen.h"

/// Default and limits of a task's period, from the definition of the command that sets it.
#define PERIOD_OF(command)                                                                                             \
    {COMMAND_##command##_PERIOD_MS_DEFAULT, COMMAND_##command##_PERIOD_MS_MINIMUM,                                     \
     COMMAND_##command##_PERIOD_MS_MAXIMUM}

typedef struct
{
    uint32_t default_ms;
    int32_t minimum_ms;
    int32_t maximum_ms;
} task_period_t;

static const task_period_t periods[telemetry_task_count] = {
    [telemetry_task_param] = PERIOD_OF(SET_PARAMETER_TASK_RATE),
    [telemetry_task_fms] = PERIOD_OF(SET_FMS_TASK_RATE),
    [telemetry_task_servos] = PERIOD_OF(SET_SERVOS_TASK_RATE),
};

static const telemetry_task_t tasks[telemetry_stream_count] = {
    [telemetry_heartbeat] = telemetry_task_param,  [telemetry_ahrs] = telemetry_task_param,
    [telemetry_inertial] = telemetry_task_param,   [telemetry_analog] = telemetry_task_param,
    [telemetry_fms_plan] = telemetry_task_fms,     [telemetry_fms_hil_plan] = telemetry_task_fms,
    [telemetry_statistics] = telemetry_task_fms,   [telemetry_gps] = telemetry_task_fms,
    [telemetry_servos_in] = telemetry_task_servos, [telemetry_fly_by_wire] = telemetry_task_servos,
};

void telemetry_init(telemetry_schedule_t* schedule)
{
    memset(schedule, 0, sizeof *schedule);
    schedule->on[telemetry_heartbeat] = true;
    for (size_t task = 0; task < telemetry_task_count; task++)
    {
        schedule->period_ms[task] = periods[task].default_ms;
    }
}

void telemetry_switch(telemetry_schedule_t* schedule, telemetry_stream_t stream, bool on)
{
    if (stream != telemetry_heartbeat)
    {
        schedule->on[stream] = on;
    }
}

void telemetry_switch_all(telemetry_schedule_t* schedule, bool on)
{
    for (size_t stream = 0; stream < telemetry_stream_count; stream++)
    {
        telemetry_switch(schedule, (telemetry_stream_t)stream, on);
    }
}

bool telemetry_is_due(const telemetry_schedule_t* schedule, telemetry_task_t task, telemetry_stream_t stream)
{
    return tasks[stream] == task && schedule->on[stream];
}

bool telemetry_set_period(telemetry_schedule_t* schedule, telemetry_task_t task, int32_t period_ms)
{
    if (period_ms < periods[task].minimum_ms || period_ms > periods[task].maximum_ms)
    {
        return false;
    }
    schedule->period_ms[task] = (uint32_t)period_ms;
    return true;
}

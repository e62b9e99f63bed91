/// Which stream is sent by which task, which streams are on, and how often each task runs.
#ifndef COMMS_TELEMETRY_H
#define COMMS_TELEMETRY_H

#include <stdbool.h>
#include <stdint.h>

/// The three tasks that send by themselves, in the order of commands 46, 47 and 48.
typedef enum
{
    telemetry_task_param,  ///< qParamTask: heartbeat (always), ahrs, inertial, analog
    telemetry_task_fms,    ///< qFMSTask: both plans, statistics, gps
    telemetry_task_servos, ///< qServosTask: receiver channels and fly-by-wire
    telemetry_task_count
} telemetry_task_t;

/// In the order in which one task sends them.
typedef enum
{
    telemetry_heartbeat,
    telemetry_ahrs,
    telemetry_inertial,
    telemetry_analog,
    telemetry_fms_plan,
    telemetry_fms_hil_plan,
    telemetry_statistics,
    telemetry_gps,
    telemetry_servos_in,
    telemetry_fly_by_wire,
    telemetry_stream_count
} telemetry_stream_t;

typedef struct
{
    bool on[telemetry_stream_count];
    uint32_t period_ms[telemetry_task_count];
} telemetry_schedule_t;

/// All streams off but the heartbeat, default periods (100, 100 and 20 ms).
void telemetry_init(telemetry_schedule_t* schedule);

/// Switch one stream. The heartbeat cannot be switched off.
void telemetry_switch(telemetry_schedule_t* schedule, telemetry_stream_t stream, bool on);

/// Switch all streams but the heartbeat.
void telemetry_switch_all(telemetry_schedule_t* schedule, bool on);

/// True when `task` has to send `stream` in each of its periods.
bool telemetry_is_due(const telemetry_schedule_t* schedule, telemetry_task_t task, telemetry_stream_t stream);

/// Set a task's period; false, and nothing changed, outside of its range (20..10000, FMS 50..10000 ms).
bool telemetry_set_period(telemetry_schedule_t* schedule, telemetry_task_t task, int32_t period_ms);

#endif

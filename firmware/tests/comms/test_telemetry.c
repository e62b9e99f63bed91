#include "support/cmocka_all.h"

#include "comms/telemetry.h"

static size_t due_of(const telemetry_schedule_t* schedule, telemetry_task_t task)
{
    size_t due = 0;
    for (size_t stream = 0; stream < telemetry_stream_count; stream++)
    {
        due += telemetry_is_due(schedule, task, (telemetry_stream_t)stream) ? 1 : 0;
    }
    return due;
}

static void at_start_only_the_heartbeat_is_due(void** state)
{
    (void)state;
    telemetry_schedule_t schedule;
    telemetry_init(&schedule);
    assert_true(telemetry_is_due(&schedule, telemetry_task_param, telemetry_heartbeat));
    assert_int_equal(due_of(&schedule, telemetry_task_param), 1);
    assert_int_equal(due_of(&schedule, telemetry_task_fms), 0);
    assert_int_equal(due_of(&schedule, telemetry_task_servos), 0);
}

static void each_stream_belongs_to_one_task(void** state)
{
    (void)state;
    telemetry_schedule_t schedule;
    telemetry_init(&schedule);
    telemetry_switch_all(&schedule, true);
    assert_int_equal(due_of(&schedule, telemetry_task_param), 4);
    assert_int_equal(due_of(&schedule, telemetry_task_fms), 4);
    assert_int_equal(due_of(&schedule, telemetry_task_servos), 2);
    assert_true(telemetry_is_due(&schedule, telemetry_task_param, telemetry_analog));
    assert_true(telemetry_is_due(&schedule, telemetry_task_fms, telemetry_gps));
    assert_true(telemetry_is_due(&schedule, telemetry_task_fms, telemetry_statistics));
    assert_true(telemetry_is_due(&schedule, telemetry_task_servos, telemetry_servos_in));
    assert_true(telemetry_is_due(&schedule, telemetry_task_servos, telemetry_fly_by_wire));
}

static void the_heartbeat_cannot_be_switched_off(void** state)
{
    (void)state;
    telemetry_schedule_t schedule;
    telemetry_init(&schedule);
    telemetry_switch(&schedule, telemetry_heartbeat, false);
    telemetry_switch_all(&schedule, false);
    assert_true(telemetry_is_due(&schedule, telemetry_task_param, telemetry_heartbeat));
}

static void one_stream_is_switched_without_the_others(void** state)
{
    (void)state;
    telemetry_schedule_t schedule;
    telemetry_init(&schedule);
    telemetry_switch(&schedule, telemetry_gps, true);
    assert_int_equal(due_of(&schedule, telemetry_task_fms), 1);
    telemetry_switch(&schedule, telemetry_gps, false);
    assert_int_equal(due_of(&schedule, telemetry_task_fms), 0);
}

static void periods_are_the_deployed_ones_and_stay_in_their_range(void** state)
{
    (void)state;
    telemetry_schedule_t schedule;
    telemetry_init(&schedule);
    assert_int_equal(schedule.period_ms[telemetry_task_param], 100);
    assert_int_equal(schedule.period_ms[telemetry_task_fms], 100);
    assert_int_equal(schedule.period_ms[telemetry_task_servos], 20);
    assert_true(telemetry_set_period(&schedule, telemetry_task_param, 20));
    assert_true(telemetry_set_period(&schedule, telemetry_task_fms, 50));
    assert_true(telemetry_set_period(&schedule, telemetry_task_servos, 10000));
    assert_false(telemetry_set_period(&schedule, telemetry_task_param, 19));
    assert_false(telemetry_set_period(&schedule, telemetry_task_fms, 49));
    assert_false(telemetry_set_period(&schedule, telemetry_task_servos, 10001));
    assert_false(telemetry_set_period(&schedule, telemetry_task_servos, -20));
    assert_int_equal(schedule.period_ms[telemetry_task_param], 20);
    assert_int_equal(schedule.period_ms[telemetry_task_fms], 50);
    assert_int_equal(schedule.period_ms[telemetry_task_servos], 10000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(at_start_only_the_heartbeat_is_due),
        cmocka_unit_test(each_stream_belongs_to_one_task),
        cmocka_unit_test(the_heartbeat_cannot_be_switched_off),
        cmocka_unit_test(one_stream_is_switched_without_the_others),
        cmocka_unit_test(periods_are_the_deployed_ones_and_stay_in_their_range),
    };
    return cmocka_run_group_tests_name("comms.telemetry", tests, NULL, NULL);
}

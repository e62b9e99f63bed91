#include "support/cmocka_all.h"

#include "flight/measurements.h"

static const float step_s = 0.02F;

/// Everything measured, the stick off the middle.
static measurements_t complete(void)
{
    measurements_t measured = {
        .sensors = {.gps = {.valid = 'A'}},
    };
    measured.sensors.servos_in.channel[rc_channel_aileron] = 0.1F;
    measured.sensors.servos_in.channel[rc_channel_elevator] = 0.2F;
    measured.sensors.servos_in.channel[rc_channel_throttle] = 0.6F;
    measured.sensors.servos_in.channel[rc_channel_rudder] = 0.3F;
    measured.sensors.servos_in.channel[rc_channel_autopilot] = 1.0F;
    measured.sensors.servos_in.channel[rc_channel_autotrim] = -1.0F;
    measurements_note(&measured, step_s);
    return measured;
}

static void note_for(measurements_t* measured, float seconds)
{
    const long steps = lroundf(seconds / step_s);
    for (long i = 0; i < steps; i++)
    {
        measurements_note(measured, step_s);
    }
}

static size_t active(const measurements_t* measured)
{
    size_t count = 0;
    for (size_t cause = 0; cause < failsafe_count; cause++)
    {
        count += failsafe_is_active(&measured->missing, (failsafe_cause_t)cause) ? 1U : 0U;
    }
    return count;
}

static void with_everything_measured_nothing_is_missing(void** state)
{
    (void)state;
    measurements_t measured = complete();
    note_for(&measured, 5.0F);
    assert_int_equal(active(&measured), 0);
}

static void each_value_that_is_not_measured_is_missing_under_its_own_cause(void** state)
{
    (void)state;
    measurements_t prototype = complete();
    struct
    {
        float* value;
        failsafe_cause_t cause;
    } const rows[] = {
        {&prototype.sensors.servos_in.channel[11], failsafe_receiver_silent},
        {&prototype.sensors.inertial.gx_rad_s, failsafe_rates_unknown},
        {&prototype.sensors.inertial.gy_rad_s, failsafe_rates_unknown},
        {&prototype.sensors.inertial.gz_rad_s, failsafe_rates_unknown},
        {&prototype.sensors.ahrs.pitch_deg, failsafe_attitude_unknown},
        {&prototype.sensors.ahrs.roll_deg, failsafe_attitude_unknown},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
    {
        const float known = *rows[i].value;
        *rows[i].value = NAN;
        measurements_t measured = prototype;
        note_for(&measured, 2.0F);
        assert_int_equal(active(&measured), 1);
        assert_true(failsafe_is_active(&measured.missing, rows[i].cause));
        *rows[i].value = known;
    }
}

static void direction_and_altitude_have_two_sources_each(void** state)
{
    (void)state;
    measurements_t measured = complete();
    measured.sensors.ahrs.yaw_deg = NAN;
    measured.sensors.analog.altitude_m = NAN;
    note_for(&measured, 2.0F);
    assert_int_equal(active(&measured), 0);
    measured.sensors.gps.valid = 'V';
    note_for(&measured, 2.0F);
    assert_int_equal(active(&measured), 2);
    assert_true(failsafe_is_active(&measured.missing, failsafe_attitude_unknown));
    assert_true(failsafe_is_active(&measured.missing, failsafe_altitude_unknown));
}

static void a_channel_that_is_not_heard_keeps_its_last_value(void** state)
{
    (void)state;
    measurements_t measured = complete();
    measured.sensors.servos_in.channel[rc_channel_rudder] = NAN;
    measured.sensors.servos_in.channel[rc_channel_autopilot] = NAN;
    measurements_note(&measured, step_s);
    assert_close(measurements_channel(&measured, rc_channel_rudder), 0.3F, 0.0);
    assert_true(measurements_autopilot(&measured));
    assert_false(measurements_autotrim(&measured));
}

/// Sensing and control loop are two tasks: of two readings between two steps, the first counts too.
static void a_switch_that_was_heard_once_is_remembered_before_the_next_step(void** state)
{
    (void)state;
    measurements_t measured = complete();
    measured.sensors.servos_in.channel[rc_channel_autopilot] = -1.0F;
    assert_true(measurements_hear_receiver(&measured));
    measured.sensors.servos_in.channel[rc_channel_autopilot] = NAN;
    assert_false(measurements_hear_receiver(&measured));
    measurements_note(&measured, step_s);
    assert_false(measurements_autopilot(&measured));
}

static void the_stick_is_the_transmitters_until_the_receiver_is_silent(void** state)
{
    (void)state;
    measurements_t measured = complete();
    measured.sensors.servos_in.channel[rc_channel_rudder] = 3.0F; // beyond its stop
    measurements_note(&measured, step_s);
    surfaces_t stick = measurements_stick(&measured);
    assert_close(stick.aileron, 0.1F, 0.0);
    assert_close(stick.elevator, 0.2F, 0.0);
    assert_close(stick.throttle, 0.6F, 0.0);
    assert_close(stick.rudder, 1.0, 0.0);
    for (size_t i = 0; i < 12; i++)
    {
        measured.sensors.servos_in.channel[i] = NAN;
    }
    note_for(&measured, 0.4F);
    assert_close(measurements_stick(&measured).throttle, 0.6F, 0.0);
    note_for(&measured, 0.2F);
    stick = measurements_stick(&measured);
    assert_memory_equal(&stick, &failsafe_surfaces, sizeof stick);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(with_everything_measured_nothing_is_missing),
        cmocka_unit_test(each_value_that_is_not_measured_is_missing_under_its_own_cause),
        cmocka_unit_test(direction_and_altitude_have_two_sources_each),
        cmocka_unit_test(a_channel_that_is_not_heard_keeps_its_last_value),
        cmocka_unit_test(a_switch_that_was_heard_once_is_remembered_before_the_next_step),
        cmocka_unit_test(the_stick_is_the_transmitters_until_the_receiver_is_silent),
    };
    return cmocka_run_group_tests_name("flight.measurements", tests, NULL, NULL);
}

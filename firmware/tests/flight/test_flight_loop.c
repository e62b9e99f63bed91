#include "support/cmocka_all.h"

#include "flight/flight_loop.h"
#include "support/rig.h"

static const float step_s = 0.02F;

/// A board in level flight at 1000 ft and 55 kt, everything measured, the pilot's stick off the middle.
static rig_t* rig_in_flight(bool autopilot)
{
    rig_t* const rig = rig_start();
    board_sensors_t* const sensors = &rig->board.measured.sensors;
    *sensors = (board_sensors_t){
        .ahrs = {.yaw_deg = 28.0F},
        .analog = {.altitude_m = 304.8F, .calibrated_airspeed_kt = 55.0F},
        .gps = {.latitude_deg = 27.95F,
                .longitude_deg = -15.38F,
                .altitude_m = 304.8F,
                .speed_kt = 55.0F,
                .heading_deg = 28.0F,
                .valid = 'A'},
    };
    sensors->servos_in.channel[rc_channel_aileron] = 0.1F;
    sensors->servos_in.channel[rc_channel_elevator] = 0.2F;
    sensors->servos_in.channel[rc_channel_throttle] = 0.6F;
    sensors->servos_in.channel[rc_channel_rudder] = 0.3F;
    sensors->servos_in.channel[rc_channel_autopilot] = autopilot ? 1.0F : -1.0F;
    sensors->servos_in.channel[rc_channel_autotrim] = -1.0F;
    return rig;
}

static surfaces_t fly(rig_t* rig, float seconds)
{
    const long steps = lroundf(seconds / step_s);
    for (long i = 0; i < steps; i++)
    {
        board_flight_step(&rig->board, step_s);
    }
    return rig->board.flight.loop.surfaces;
}

static void silence_receiver(rig_t* rig)
{
    for (size_t i = 0; i < 12; i++)
    {
        rig->board.measured.sensors.servos_in.channel[i] = NAN;
    }
}

static void assert_neutral(surfaces_t surfaces)
{
    assert_close(surfaces.elevator, 0.0, 1e-6);
    assert_close(surfaces.aileron, 0.0, 1e-6);
    assert_close(surfaces.rudder, 0.0, 1e-6);
    assert_close(surfaces.throttle, (double)failsafe_surfaces.throttle, 1e-6);
}

static void a_short_gap_of_the_receiver_is_bridged_with_what_was_heard_last(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(false);
    const surfaces_t before = fly(rig, 1.0F);
    silence_receiver(rig);
    const surfaces_t after = fly(rig, 0.4F);
    assert_close(after.elevator, before.elevator, 1e-6);
    assert_close(after.throttle, 0.6, 1e-6);
}

static void a_silent_receiver_lets_the_stick_go(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(false);
    (void)fly(rig, 1.0F);
    silence_receiver(rig);
    assert_neutral(fly(rig, 5.0F));
    // Damped still: a rate is answered.
    rig->board.measured.sensors.inertial.gx_rad_s = 0.5F;
    assert_true(fly(rig, 1.0F).aileron < -0.01F);
}

static void a_silent_receiver_does_not_switch_the_autopilot_off(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(true);
    (void)fly(rig, 1.0F);
    silence_receiver(rig);
    rig->board.measured.sensors.ahrs.roll_deg = 20.0F; // it levels the wings
    const surfaces_t surfaces = fly(rig, 5.0F);
    assert_true(measurements_autopilot(&rig->board.measured));
    assert_true(surfaces.aileron < -0.01F);
    assert_true(surfaces.throttle > 0.3F);
}

static void a_receiver_that_is_heard_again_flies_again_without_a_jump(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(false);
    const surfaces_t before = fly(rig, 1.0F);
    const message_servos_in_t heard = rig->board.measured.sensors.servos_in;
    silence_receiver(rig);
    (void)fly(rig, 5.0F);
    rig->board.measured.sensors.servos_in = heard;
    assert_close(fly(rig, 5.0F).elevator, before.elevator, 1e-3);
}

static void without_rates_the_stick_moves_the_surfaces_itself(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(false);
    (void)fly(rig, 1.0F);
    rig->board.measured.sensors.inertial.gy_rad_s = NAN;
    const surfaces_t surfaces = fly(rig, 1.0F);
    assert_close(surfaces.elevator, 0.2, 1e-6);
    assert_close(surfaces.aileron, 0.1, 1e-6);
    assert_close(surfaces.rudder, 0.3, 1e-6);
    assert_close(surfaces.throttle, 0.6, 1e-6);
}

static void without_rates_the_autopilot_lets_the_aircraft_glide(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(true);
    (void)fly(rig, 1.0F);
    rig->board.measured.sensors.inertial.gy_rad_s = NAN;
    assert_neutral(fly(rig, 1.0F));
}

static void without_attitude_the_autopilot_lets_the_aircraft_glide_and_comes_back_without_a_jump(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(true);
    (void)fly(rig, 1.0F);
    rig->board.measured.sensors.ahrs.pitch_deg = NAN;
    assert_neutral(fly(rig, 1.0F));
    rig->board.measured.sensors.ahrs.pitch_deg = 0.0F;
    const surfaces_t first = fly(rig, step_s);
    assert_close(first.throttle, (double)failsafe_surfaces.throttle, 0.05);
    assert_close(first.elevator, 0.0, 0.05);
}

static void without_attitude_and_altitude_a_pilot_flies_on_damped(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(false);
    const surfaces_t before = fly(rig, 1.0F);
    board_sensors_t* const sensors = &rig->board.measured.sensors;
    sensors->ahrs = (message_ahrs_t){NAN, NAN, NAN};
    sensors->analog.altitude_m = NAN;
    sensors->gps.valid = 'V';
    const surfaces_t after = fly(rig, 1.0F);
    assert_close(after.elevator, before.elevator, 1e-3);
    assert_close(after.throttle, 0.6, 1e-6);
    sensors->inertial.gx_rad_s = 0.5F;
    assert_true(fly(rig, 1.0F).aileron < after.aileron);
}

static void without_altitude_the_autopilot_neither_climbs_nor_dives(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(true);
    const surfaces_t before = fly(rig, 2.0F);
    rig->board.measured.sensors.analog.altitude_m = NAN;
    rig->board.measured.sensors.gps.valid = 'V';
    const surfaces_t after = fly(rig, 2.0F);
    assert_close(after.elevator, before.elevator, 0.03);
    assert_true(after.throttle > 0.3F);
}

static void silent_receiver_and_no_rates_together_leave_nothing_commanded(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(false);
    (void)fly(rig, 1.0F);
    silence_receiver(rig);
    rig->board.measured.sensors.inertial.gy_rad_s = NAN;
    assert_neutral(fly(rig, 2.0F));
}

static void the_real_loop_flies_by_the_sources_that_were_selected(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    board_sensors_t* const sensors = &rig->board.measured.sensors;
    sensors->gps = (message_gps_t){.latitude_deg = 27.9F,
                                   .longitude_deg = -15.4F,
                                   .altitude_m = 300.0F,
                                   .speed_kt = 60.0F,
                                   .heading_deg = 77.0F,
                                   .valid = 'A'};
    sensors->analog.altitude_m = 310.0F;
    sensors->analog.calibrated_airspeed_kt = 50.0F;
    control_loop_input_t input = flight_loop_input(&rig->board.flight, &rig->board.measured);
    assert_close(input.speed_kt, 50.0, 0.0);
    assert_close(input.altitude_ft, 310.0 * 3.28084, 0.01);
    assert_close(input.direction_deg, 77.0, 0.0);
    (void)rig_do_with(rig, COMMAND_SELECT_AIRSPEED_SOURCE_ID, 0);
    (void)rig_do_with(rig, COMMAND_SELECT_ALTITUDE_SOURCE_ID, 0);
    input = flight_loop_input(&rig->board.flight, &rig->board.measured);
    assert_close(input.speed_kt, 60.0, 0.0);
    assert_close(input.altitude_ft, 300.0 * 3.28084, 0.01);
}

static void a_source_that_measures_nothing_is_replaced_by_the_other(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    board_sensors_t* const sensors = &rig->board.measured.sensors;
    sensors->gps = (message_gps_t){.altitude_m = 300.0F, .speed_kt = 60.0F, .heading_deg = 77.0F, .valid = 'A'};
    sensors->ahrs.yaw_deg = 12.0F;
    sensors->analog.altitude_m = NAN;
    sensors->analog.calibrated_airspeed_kt = NAN;
    sensors->analog.vvi_ft_min = NAN;
    control_loop_input_t input = flight_loop_input(&rig->board.flight, &rig->board.measured);
    assert_close(input.speed_kt, 60.0, 0.0);
    assert_close(input.altitude_ft, 300.0 * 3.28084, 0.01);
    assert_close(input.vvi_ft_min, 0.0, 0.0);
    sensors->gps.valid = 'V';
    input = flight_loop_input(&rig->board.flight, &rig->board.measured);
    assert_close(input.speed_kt, 0.0, 0.0);
    assert_close(input.direction_deg, 12.0, 0.0);
    assert_false(position_is_valid(&input.position));
}

static void the_real_loop_puts_its_surfaces_into_the_fly_by_wire_stream(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig->board.measured.sensors.servos_in.channel[rc_channel_throttle] = 0.7F;
    rig->board.measured.sensors.servos_in.channel[rc_channel_elevator] = 0.1F;
    board_flight_step(&rig->board, 0.02F);
    (void)rig_do(rig, COMMAND_FLY_BY_WIRE_ON_ID);
    board_send_streams(&rig->board, telemetry_task_servos);
    message_fly_by_wire_t values;
    message_fly_by_wire_unpack(&values, line_newest(&rig->out, MESSAGE_FLY_BY_WIRE_ID)->payload);
    assert_close(values.throttle, 0.7, 1e-6);
    assert_close(values.elevator, 0.2, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_short_gap_of_the_receiver_is_bridged_with_what_was_heard_last),
        cmocka_unit_test(a_silent_receiver_lets_the_stick_go),
        cmocka_unit_test(a_silent_receiver_does_not_switch_the_autopilot_off),
        cmocka_unit_test(a_receiver_that_is_heard_again_flies_again_without_a_jump),
        cmocka_unit_test(without_rates_the_stick_moves_the_surfaces_itself),
        cmocka_unit_test(without_rates_the_autopilot_lets_the_aircraft_glide),
        cmocka_unit_test(without_attitude_the_autopilot_lets_the_aircraft_glide_and_comes_back_without_a_jump),
        cmocka_unit_test(without_attitude_and_altitude_a_pilot_flies_on_damped),
        cmocka_unit_test(without_altitude_the_autopilot_neither_climbs_nor_dives),
        cmocka_unit_test(silent_receiver_and_no_rates_together_leave_nothing_commanded),
        cmocka_unit_test(the_real_loop_flies_by_the_sources_that_were_selected),
        cmocka_unit_test(a_source_that_measures_nothing_is_replaced_by_the_other),
        cmocka_unit_test(the_real_loop_puts_its_surfaces_into_the_fly_by_wire_stream),
    };
    return cmocka_run_group_tests_name("flight.flight_loop", tests, NULL, NULL);
}

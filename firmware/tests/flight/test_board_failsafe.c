#include "support/cmocka_all.h"

#include "flight/board_failsafe.h"
#include "support/rig.h"

static const float step_s = 0.02F;

/// A board in level flight at 1000 ft and 55 kt, everything measured, the pilot's stick off the middle.
static rig_t* rig_in_flight(bool autopilot)
{
    rig_t* const rig = rig_start();
    board_sensors_t* const sensors = &rig->board.sensors;
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
    return rig->board.loops[board_plan_flight].surfaces;
}

static void silence_receiver(rig_t* rig)
{
    for (size_t i = 0; i < 12; i++)
    {
        rig->board.sensors.servos_in.channel[i] = NAN;
    }
}

static void assert_neutral(surfaces_t surfaces)
{
    assert_close(surfaces.elevator, 0.0, 1e-6);
    assert_close(surfaces.aileron, 0.0, 1e-6);
    assert_close(surfaces.rudder, 0.0, 1e-6);
    assert_close(surfaces.throttle, (double)failsafe_throttle, 1e-6);
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
    rig->board.sensors.inertial.gx_rad_s = 0.5F;
    assert_true(fly(rig, 1.0F).aileron < -0.01F);
}

static void a_silent_receiver_does_not_switch_the_autopilot_off(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(true);
    (void)fly(rig, 1.0F);
    silence_receiver(rig);
    rig->board.sensors.ahrs.roll_deg = 20.0F; // it levels the wings
    const surfaces_t surfaces = fly(rig, 5.0F);
    assert_true(board_flight_autopilot(&rig->board));
    assert_true(surfaces.aileron < -0.01F);
    assert_true(surfaces.throttle > 0.3F);
}

static void a_receiver_that_is_heard_again_flies_again_without_a_jump(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(false);
    const surfaces_t before = fly(rig, 1.0F);
    const message_servos_in_t heard = rig->board.sensors.servos_in;
    silence_receiver(rig);
    (void)fly(rig, 5.0F);
    rig->board.sensors.servos_in = heard;
    assert_close(fly(rig, 5.0F).elevator, before.elevator, 1e-3);
}

static void without_rates_the_stick_moves_the_surfaces_itself(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(false);
    (void)fly(rig, 1.0F);
    rig->board.sensors.inertial.gy_rad_s = NAN;
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
    rig->board.sensors.inertial.gy_rad_s = NAN;
    assert_neutral(fly(rig, 1.0F));
}

static void without_attitude_the_autopilot_lets_the_aircraft_glide_and_comes_back_without_a_jump(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(true);
    (void)fly(rig, 1.0F);
    rig->board.sensors.ahrs.pitch_deg = NAN;
    assert_neutral(fly(rig, 1.0F));
    rig->board.sensors.ahrs.pitch_deg = 0.0F;
    const surfaces_t first = fly(rig, step_s);
    assert_close(first.throttle, (double)failsafe_throttle, 0.05);
    assert_close(first.elevator, 0.0, 0.05);
}

static void without_attitude_and_altitude_a_pilot_flies_on_damped(void** state)
{
    (void)state;
    rig_t* const rig = rig_in_flight(false);
    const surfaces_t before = fly(rig, 1.0F);
    board_sensors_t* const sensors = &rig->board.sensors;
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
    rig->board.sensors.analog.altitude_m = NAN;
    rig->board.sensors.gps.valid = 'V';
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
    rig->board.sensors.inertial.gy_rad_s = NAN;
    assert_neutral(fly(rig, 2.0F));
}

static void a_simulator_that_stops_centres_the_stick_pilots_surfaces(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
    command_xplane_info_t info = rig_level_flight();
    info.elevator = 0.3F;
    (void)rig_fly(rig, &info);
    const surfaces_t* const surfaces = &rig->board.loops[board_plan_hil].surfaces;
    board_supervise_hil(&rig->board, rig->board.xplane_info_ms + 480);
    assert_close(surfaces->elevator, 0.6, 1e-6);
    board_supervise_hil(&rig->board, rig->board.xplane_info_ms + 500);
    assert_neutral(*surfaces);
}

static void a_simulator_that_stops_leaves_the_autopilots_surfaces_as_they_are(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
    (void)rig_do(rig, COMMAND_AUTOPILOT_ON_ID);
    command_xplane_info_t info = rig_level_flight();
    info.roll_deg = 20.0F;
    (void)rig_fly(rig, &info);
    const message_hil_surfaces_t before = rig_fly(rig, &info);
    board_supervise_hil(&rig->board, rig->board.xplane_info_ms + 60000);
    assert_true(before.aileron < -0.01F);
    assert_close(rig->board.loops[board_plan_hil].surfaces.aileron, before.aileron, 1e-6);
    assert_close(rig->board.loops[board_plan_hil].surfaces.throttle, before.throttle, 1e-6);
}

static void before_the_first_command_50_no_simulator_is_missed(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    board_supervise_hil(&rig->board, 60000);
    assert_false(failsafe_is_active(&rig->board.failsafe, failsafe_simulator_silent));
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
        cmocka_unit_test(a_simulator_that_stops_centres_the_stick_pilots_surfaces),
        cmocka_unit_test(a_simulator_that_stops_leaves_the_autopilots_surfaces_as_they_are),
        cmocka_unit_test(before_the_first_command_50_no_simulator_is_missed),
    };
    return cmocka_run_group_tests_name("flight.board_failsafe", tests, NULL, NULL);
}

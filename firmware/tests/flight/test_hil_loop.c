#include "support/cmocka_all.h"

#include "flight/hil_loop.h"
#include "support/rig.h"

static void assert_usable(message_hil_surfaces_t surfaces)
{
    assert_true(surfaces.elevator >= -1.0F && surfaces.elevator <= 1.0F);
    assert_true(surfaces.aileron >= -1.0F && surfaces.aileron <= 1.0F);
    assert_true(surfaces.rudder >= -1.0F && surfaces.rudder <= 1.0F);
    assert_true(surfaces.throttle >= 0.0F && surfaces.throttle <= 1.0F);
}

static void every_command_50_is_answered_by_one_surfaces_frame(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    command_xplane_info_t info = rig_level_flight();
    for (int i = 0; i < 100; i++)
    {
        info.roll_deg = (float)i / 5.0F;
        assert_usable(rig_fly(rig, &info));
    }
    assert_int_equal(rig->board.hil.accepted, 100);
}

static void with_the_joystick_the_stick_of_command_50_flies(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
    command_xplane_info_t info = rig_level_flight();
    info.elevator = 0.1F;
    info.aileron = -0.2F;
    info.rudder = 0.3F;
    info.throttle = 0.4F;
    rig->board.measured.sensors.servos_in.channel[rc_channel_elevator] = -0.9F; // not this one
    const message_hil_surfaces_t surfaces = rig_fly(rig, &info);
    assert_close(surfaces.elevator, 0.2, 1e-6);
    assert_close(surfaces.aileron, 0.6 * -0.6, 1e-6);
    assert_close(surfaces.rudder, 0.3, 1e-6);
    assert_close(surfaces.throttle, 0.4, 1e-6);
}

static void with_rc_the_receivers_channels_fly(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    float* const channel = rig->board.measured.sensors.servos_in.channel;
    channel[rc_channel_aileron] = 0.1F;
    channel[rc_channel_elevator] = -0.2F;
    channel[rc_channel_throttle] = 0.8F;
    channel[rc_channel_rudder] = 0.3F;
    command_xplane_info_t info = rig_level_flight();
    info.elevator = 0.9F; // not this one
    const message_hil_surfaces_t surfaces = rig_fly(rig, &info);
    assert_close(surfaces.elevator, -0.4, 1e-6);
    assert_close(surfaces.aileron, 0.6 * 0.3, 1e-6);
    assert_close(surfaces.rudder, 0.3, 1e-6);
    assert_close(surfaces.throttle, 0.8, 1e-6);
}

static void each_rate_of_command_50_is_damped_on_its_own_axis(void** state)
{
    (void)state;
    const float rates[3][3] = {{0.5F, 0.0F, 0.0F}, {0.0F, 0.5F, 0.0F}, {0.0F, 0.0F, 0.5F}};
    for (size_t axis = 0; axis < 3; axis++)
    {
        rig_t* const rig = rig_start();
        command_xplane_info_t info = rig_level_flight();
        info.gx_rad_s = rates[axis][0];
        info.gy_rad_s = rates[axis][1];
        info.gz_rad_s = rates[axis][2];
        const message_hil_surfaces_t surfaces = rig_fly(rig, &info);
        assert_int_equal(surfaces.aileron < 0.0F, axis == 0);
        assert_int_equal(surfaces.elevator < 0.0F, axis == 1);
        assert_int_equal(surfaces.rudder < 0.0F, axis == 2);
    }
}

static void a_stick_beyond_its_stops_counts_as_at_its_stops(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
    command_xplane_info_t info = rig_level_flight();
    info.rudder = 7.0F;
    info.throttle = -3.0F;
    const message_hil_surfaces_t surfaces = rig_fly(rig, &info);
    assert_close(surfaces.rudder, 1.0, 0.0);
    assert_close(surfaces.throttle, 0.0, 0.0);
}

static void a_command_50_that_is_not_finite_keeps_the_surfaces_and_is_counted(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
    command_xplane_info_t info = rig_level_flight();
    info.elevator = 0.2F;
    const message_hil_surfaces_t good = rig_fly(rig, &info);
    for (size_t i = 0; i < COMMAND_XPLANE_INFO_SIZE / 4; i++)
    {
        const float bad[] = {NAN, INFINITY, -INFINITY};
        for (size_t j = 0; j < 3; j++)
        {
            uint8_t payload[COMMAND_XPLANE_INFO_SIZE];
            command_xplane_info_pack(&info, payload);
            protocol_put_f32(payload + 4 * i, bad[j]);
            command_xplane_info_t broken;
            command_xplane_info_unpack(&broken, payload);
            const message_hil_surfaces_t surfaces = rig_fly(rig, &broken);
            assert_memory_equal(&surfaces, &good, sizeof good);
        }
    }
    assert_int_equal(rig->board.hil.refused, 45);
    assert_int_equal(rig->board.hil.accepted, 1);
    const message_hil_surfaces_t after = rig_fly(rig, &info);
    assert_memory_equal(&after, &good, sizeof good);
}

static void finite_values_of_any_size_give_usable_surfaces(void** state)
{
    (void)state;
    const float sizes[] = {3e38F, -3e38F, 1e-38F, -999.0F};
    for (size_t i = 0; i < COMMAND_XPLANE_INFO_SIZE / 4; i++)
    {
        for (size_t j = 0; j < sizeof sizes / sizeof sizes[0]; j++)
        {
            rig_t* const rig = rig_start();
            (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
            (void)rig_do(rig, COMMAND_AUTOTRIM_ON_ID);
            (void)rig_do(rig, COMMAND_AUTOPILOT_ON_ID);
            (void)rig_do(rig, COMMAND_HIL_LOAD_GANDO_ID);
            command_xplane_info_t info = rig_level_flight();
            uint8_t payload[COMMAND_XPLANE_INFO_SIZE];
            command_xplane_info_pack(&info, payload);
            protocol_put_f32(payload + 4 * i, sizes[j]);
            command_xplane_info_unpack(&info, payload);
            assert_usable(rig_fly(rig, &info));
            assert_usable(rig_fly(rig, &info));
            // and the laws have not kept any of it
            info = rig_level_flight();
            assert_usable(rig_fly(rig, &info));
        }
    }
}

/// Throttle after one more second of flight 10 kt too slow, with commands 50 `period_ms` apart.
static float throttle_after(rig_t* rig, uint32_t period_ms, uint32_t count)
{
    command_xplane_info_t info = {
        .throttle = 0.5F, .altitude_ft = 1000.0F, .speed_kt = 45.0F, .latitude_deg = 27.9F, .longitude_deg = -15.4F};
    for (uint32_t i = 0; i < count; i++)
    {
        // what flies is never twice at the same place
        const float here_deg = -15.4F;
        info.longitude_deg = rig->board.hil.newest.longitude_deg == here_deg ? -15.40001F : here_deg;
        uint8_t payload[COMMAND_XPLANE_INFO_SIZE];
        command_xplane_info_pack(&info, payload);
        rig->now_ms += period_ms;
        (void)rig_send(rig, COMMAND_XPLANE_INFO_ID, payload, sizeof payload);
    }
    return rig->board.hil.loop.autopilot.throttle;
}

static rig_t* start_measured(void)
{
    rig_t* const rig = rig_start();
    rig->board.hil.period_s = 0.0F;
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
    (void)rig_do(rig, COMMAND_HIL_LOAD_GANDO_ID); // its first waypoint asks for 55 kt
    (void)rig_do(rig, COMMAND_AUTOPILOT_ON_ID);
    return rig;
}

static void the_measured_step_is_the_time_between_two_arrivals(void** state)
{
    (void)state;
    for (uint32_t period_ms = 10; period_ms <= 200; period_ms += 10)
    {
        rig_t* const rig = start_measured();
        (void)throttle_after(rig, period_ms, 1);
        const float before = throttle_after(rig, period_ms, 1);
        assert_close(throttle_after(rig, period_ms, 20) - before, 20.0 * period_ms / 1000.0 * 10.0 / 700.0, 1e-5);
    }
}

static void the_measured_step_stays_between_5_and_200_ms(void** state)
{
    (void)state;
    rig_t* rig = start_measured();
    float before = throttle_after(rig, 20, 2);
    assert_close(throttle_after(rig, 0, 1) - before, 0.005 * 10.0 / 700.0, 1e-6);
    before = throttle_after(rig, 20, 1);
    assert_close(throttle_after(rig, 450, 1) - before, 0.2 * 10.0 / 700.0, 1e-6);
}

static void after_a_pause_the_states_stay_and_nothing_is_integrated(void** state)
{
    (void)state;
    rig_t* const rig = start_measured();
    const float before = throttle_after(rig, 20, 50);
    assert_close(throttle_after(rig, 5000, 1), before, 0.0);
    assert_close(throttle_after(rig, 20, 1) - before, 0.02 * 10.0 / 700.0, 1e-6);
}

/// Send the newest command 50 again, `count` times.
static void repeat(rig_t* rig, uint32_t period_ms, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
    {
        uint8_t payload[COMMAND_XPLANE_INFO_SIZE];
        command_xplane_info_pack(&rig->board.hil.newest, payload);
        rig->now_ms += period_ms;
        (void)rig_send(rig, COMMAND_XPLANE_INFO_ID, payload, sizeof payload);
    }
}

static void a_paused_simulator_is_answered_but_moves_no_integral_and_is_not_missed(void** state)
{
    (void)state;
    rig_t* const rig = start_measured();
    (void)throttle_after(rig, 20, 50);
    const control_loop_t before = rig->board.hil.loop;
    repeat(rig, 20, 3000);
    assert_int_equal(rig->out.count, 1); // the answer to the last one
    const control_loop_t* const after = &rig->board.hil.loop;
    assert_memory_equal(&after->fly_by_wire, &before.fly_by_wire, sizeof before.fly_by_wire);
    assert_memory_equal(&after->autopilot, &before.autopilot, sizeof before.autopilot);
    assert_memory_equal(&after->track, &before.track, sizeof before.track);
    assert_memory_equal(&after->surfaces, &before.surfaces, sizeof before.surfaces);
    assert_int_equal(rig->board.hil.repeated, 3000);
    board_supervise_hil(&rig->board, rig->now_ms);
    assert_false(failsafe_is_active(&rig->board.hil.missing, failsafe_simulator_silent));
}

static void the_first_step_after_a_pause_is_no_longer_than_any_other(void** state)
{
    (void)state;
    for (uint32_t frames = 1; frames <= 3000; frames = frames * 3 + 7)
    {
        rig_t* const rig = start_measured();
        const float before = throttle_after(rig, 20, 50);
        repeat(rig, 20, frames);
        const float first = throttle_after(rig, 20, 1) - before;
        assert_true(first <= 0.2F * 10.0F / 700.0F + 1e-6F);
        assert_close(throttle_after(rig, 20, 1) - before - first, 0.02 * 10.0 / 700.0, 1e-6);
    }
}

static void a_simulator_that_sends_every_picture_three_times_takes_the_time_that_passes(void** state)
{
    (void)state;
    rig_t* const rig = start_measured();
    (void)throttle_after(rig, 10, 1);
    const float before = throttle_after(rig, 10, 1);
    for (int i = 0; i < 20; i++)
    {
        repeat(rig, 10, 2);
        (void)throttle_after(rig, 10, 1);
    }
    assert_close(rig->board.hil.loop.autopilot.throttle - before, 20 * 0.03 * 10.0 / 700.0, 1e-5);
}

static void a_stick_that_moves_in_a_pause_moves_the_surfaces_and_nothing_else(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
    (void)rig_do(rig, COMMAND_AUTOTRIM_ON_ID);
    command_xplane_info_t info = rig_level_flight();
    (void)rig_fly(rig, &info);
    const float trim = rig->board.hil.loop.fly_by_wire.trim;
    for (int i = 0; i < 100; i++)
    {
        info.elevator = 0.1F + (float)i / 1000.0F;
        (void)rig_fly(rig, &info);
    }
    assert_close(rig->board.hil.loop.fly_by_wire.trim, trim, 0.0);
    assert_close(rig->board.hil.loop.surfaces.elevator, (double)(trim + 2.0F * info.elevator), 1e-6);
}

static void an_aircraft_that_stands_on_the_ground_is_not_paused(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
    command_xplane_info_t info = rig_level_flight();
    info.speed_kt = 0.0F;
    (void)rig_fly(rig, &info);
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 0); // the receiver's throttle is closed: the jump fades away
    for (int i = 0; i < 500; i++)
    {
        (void)rig_fly(rig, &info);
    }
    assert_close(rig->board.hil.loop.surfaces.throttle, 0.0, 1e-3);
    assert_int_equal(rig->board.hil.repeated, 0);
}

static void each_value_of_the_aircraft_that_changes_is_a_flight_and_no_pause(void** state)
{
    (void)state;
    const size_t stick = 4; // values of command 50
    for (size_t i = 0; i < COMMAND_XPLANE_INFO_SIZE / 4; i++)
    {
        const command_xplane_info_t before = rig_level_flight();
        uint8_t payload[COMMAND_XPLANE_INFO_SIZE];
        command_xplane_info_pack(&before, payload);
        protocol_put_f32(payload + 4 * i, nextafterf(protocol_get_f32(payload + 4 * i), 2000.0F));
        command_xplane_info_t after;
        command_xplane_info_unpack(&after, payload);
        assert_int_equal(hil_loop_repeats(&before, &after), i < stick);
    }
}

static void a_jump_begins_the_loop_anew_and_a_flight_does_not(void** state)
{
    (void)state;
    const struct
    {
        float north_deg;
        float up_ft;
        uint32_t after_ms;
        uint32_t jumps;
    } cases[] = {
        {0.0040F, 0.0F, 20, 0},  {0.0050F, 0.0F, 20, 1},  {0.0F, 1500.0F, 20, 0},
        {0.0F, -1900.0F, 20, 1}, {0.01F, 0.0F, 20000, 0}, // 1.1 km in a silence of 20 s
        {0.05F, 0.0F, 20000, 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    {
        rig_t* const rig = start_measured();
        command_xplane_info_t info = rig_level_flight();
        info.altitude_ft = 2500.0F;
        info.speed_kt = 45.0F;
        for (int frame = 0; frame < 100; frame++)
        {
            info.latitude_deg += 0.00001F;
            (void)rig_fly(rig, &info);
        }
        assert_true(rig->board.hil.loop.autopilot.throttle != info.throttle);
        info.latitude_deg += cases[i].north_deg;
        info.altitude_ft += cases[i].up_ft;
        rig->now_ms += cases[i].after_ms - 20;
        (void)rig_fly(rig, &info);
        assert_int_equal(rig->board.hil.jumps, cases[i].jumps);
        if (cases[i].jumps != 0)
        {
            // as switched on: the throttle where the stick has it, the elevator without trim
            assert_close(rig->board.hil.loop.autopilot.throttle, (double)info.throttle, 1e-3);
            assert_true(fabsf(rig->board.hil.loop.fly_by_wire.trim) < 0.01F);
        }
    }
}

static void the_fixed_step_does_not_look_at_the_clock(void** state)
{
    (void)state;
    rig_t* const rig = start_measured();
    rig->board.hil.period_s = 0.05F;
    const float before = throttle_after(rig, 3000, 1);
    assert_close(throttle_after(rig, 3000, 10) - before, 10 * 0.05 * 10.0 / 700.0, 1e-5);
}

static void assert_neutral(surfaces_t surfaces)
{
    assert_close(surfaces.elevator, 0.0, 1e-6);
    assert_close(surfaces.aileron, 0.0, 1e-6);
    assert_close(surfaces.rudder, 0.0, 1e-6);
    assert_close(surfaces.throttle, (double)failsafe_surfaces.throttle, 1e-6);
}

static void a_simulator_that_stops_centres_the_stick_pilots_surfaces(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do_with(rig, COMMAND_CONTROL_SOURCE_ID, 1);
    command_xplane_info_t info = rig_level_flight();
    info.elevator = 0.3F;
    (void)rig_fly(rig, &info);
    const surfaces_t* const surfaces = &rig->board.hil.loop.surfaces;
    board_supervise_hil(&rig->board, rig->board.hil.arrived_ms + 480);
    assert_close(surfaces->elevator, 0.6, 1e-6);
    board_supervise_hil(&rig->board, rig->board.hil.arrived_ms + 500);
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
    board_supervise_hil(&rig->board, rig->board.hil.arrived_ms + 60000);
    assert_true(before.aileron < -0.01F);
    assert_close(rig->board.hil.loop.surfaces.aileron, before.aileron, 1e-6);
    assert_close(rig->board.hil.loop.surfaces.throttle, before.throttle, 1e-6);
}

static void before_the_first_command_50_no_simulator_is_missed(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    board_supervise_hil(&rig->board, 60000);
    assert_false(failsafe_is_active(&rig->board.hil.missing, failsafe_simulator_silent));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_command_50_is_answered_by_one_surfaces_frame),
        cmocka_unit_test(with_the_joystick_the_stick_of_command_50_flies),
        cmocka_unit_test(with_rc_the_receivers_channels_fly),
        cmocka_unit_test(each_rate_of_command_50_is_damped_on_its_own_axis),
        cmocka_unit_test(a_stick_beyond_its_stops_counts_as_at_its_stops),
        cmocka_unit_test(a_command_50_that_is_not_finite_keeps_the_surfaces_and_is_counted),
        cmocka_unit_test(finite_values_of_any_size_give_usable_surfaces),
        cmocka_unit_test(the_measured_step_is_the_time_between_two_arrivals),
        cmocka_unit_test(the_measured_step_stays_between_5_and_200_ms),
        cmocka_unit_test(after_a_pause_the_states_stay_and_nothing_is_integrated),
        cmocka_unit_test(a_paused_simulator_is_answered_but_moves_no_integral_and_is_not_missed),
        cmocka_unit_test(the_first_step_after_a_pause_is_no_longer_than_any_other),
        cmocka_unit_test(a_simulator_that_sends_every_picture_three_times_takes_the_time_that_passes),
        cmocka_unit_test(a_stick_that_moves_in_a_pause_moves_the_surfaces_and_nothing_else),
        cmocka_unit_test(an_aircraft_that_stands_on_the_ground_is_not_paused),
        cmocka_unit_test(each_value_of_the_aircraft_that_changes_is_a_flight_and_no_pause),
        cmocka_unit_test(a_jump_begins_the_loop_anew_and_a_flight_does_not),
        cmocka_unit_test(the_fixed_step_does_not_look_at_the_clock),
        cmocka_unit_test(a_simulator_that_stops_centres_the_stick_pilots_surfaces),
        cmocka_unit_test(a_simulator_that_stops_leaves_the_autopilots_surfaces_as_they_are),
        cmocka_unit_test(before_the_first_command_50_no_simulator_is_missed),
    };
    return cmocka_run_group_tests_name("flight.hil_loop", tests, NULL, NULL);
}

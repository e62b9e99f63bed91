#include "support/cmocka_all.h"

#include "flight/board_streams.h"
#include "support/rig.h"

static message_fms_plan_t hil_plan_of(rig_t* rig)
{
    line_clear(&rig->out);
    board_send_stream(&rig->board, telemetry_fms_hil_plan);
    message_fms_plan_t values;
    message_fms_plan_unpack(&values, line_newest(&rig->out, MESSAGE_FMS_HIL_PLAN_ID)->payload);
    return values;
}

static void each_stream_is_sent_as_its_own_message(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    const uint32_t ids[telemetry_stream_count] = {
        [telemetry_heartbeat] = MESSAGE_HEARTBEAT_ID,   [telemetry_ahrs] = MESSAGE_AHRS_ID,
        [telemetry_inertial] = MESSAGE_INERTIAL_ID,     [telemetry_analog] = MESSAGE_ANALOG_ID,
        [telemetry_fms_plan] = MESSAGE_FMS_PLAN_ID,     [telemetry_fms_hil_plan] = MESSAGE_FMS_HIL_PLAN_ID,
        [telemetry_statistics] = MESSAGE_STATISTICS_ID, [telemetry_gps] = MESSAGE_GPS_ID,
        [telemetry_servos_in] = MESSAGE_SERVOS_IN_ID,   [telemetry_fly_by_wire] = MESSAGE_FLY_BY_WIRE_ID,
    };
    for (size_t stream = 0; stream < telemetry_stream_count; stream++)
    {
        line_clear(&rig->out);
        board_send_stream(&rig->board, (telemetry_stream_t)stream);
        assert_int_equal(rig->out.count, 1);
        assert_int_equal(rig->out.frames[0].type_id, ids[stream]);
    }
}

static void sensor_readings_come_through_unchanged(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig->board.measured.sensors.ahrs = (message_ahrs_t){.yaw_deg = 10.5F, .pitch_deg = 5.25F, .roll_deg = -12.125F};
    rig->board.measured.sensors.analog.alpha_deg = NAN; // not measured
    rig->board.measured.sensors.analog.battery_v = 11.5F;
    line_clear(&rig->out);
    board_send_stream(&rig->board, telemetry_ahrs);
    board_send_stream(&rig->board, telemetry_analog);
    message_ahrs_t ahrs;
    message_ahrs_unpack(&ahrs, line_newest(&rig->out, MESSAGE_AHRS_ID)->payload);
    assert_memory_equal(&ahrs, &rig->board.measured.sensors.ahrs, sizeof ahrs);
    message_analog_t analog;
    message_analog_unpack(&analog, line_newest(&rig->out, MESSAGE_ANALOG_ID)->payload);
    assert_true(isnan(analog.alpha_deg));
    assert_close(analog.battery_v, 11.5, 0.0);
}

static void an_empty_plan_is_reported_as_no_data(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    const command_xplane_info_t info = rig_level_flight();
    (void)rig_fly(rig, &info);
    const message_fms_plan_t values = hil_plan_of(rig);
    assert_true(isnan(values.bearing_deg));
    assert_true(isnan(values.altitude_ft));
    assert_true(isnan(values.speed_kt));
    assert_int_equal(values.distance_m, -1);
    assert_int_equal(values.waypoint, -1);
}

static void without_a_position_a_plan_is_reported_but_for_the_way_to_its_waypoint(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do(rig, COMMAND_HIL_LOAD_GANDO_ID);
    (void)rig_do(rig, COMMAND_HIL_FMS_NEXT_WAYPOINT_ID);
    const message_fms_plan_t values = hil_plan_of(rig); // the simulator has not said where yet
    assert_true(isnan(values.bearing_deg));
    assert_int_equal(values.distance_m, -1);
    assert_close(values.altitude_ft, 1000.0, 0.0);
    assert_close(values.speed_kt, 55.0, 0.0);
    assert_int_equal(values.waypoint, 1);
}

static void a_plan_is_reported_from_where_the_aircraft_is(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do(rig, COMMAND_HIL_LOAD_GANDO_ID);
    const command_xplane_info_t info = rig_level_flight();
    (void)rig_fly(rig, &info);
    const message_fms_plan_t values = hil_plan_of(rig);
    // from the airport to 27.9515 N 15.3741 W
    assert_close(values.bearing_deg, 29.4, 0.1);
    assert_close(values.distance_m, 2502, 3.0);
    assert_close(values.altitude_ft, 700.0, 0.0);
    assert_close(values.speed_kt, 55.0, 0.0);
    assert_int_equal(values.waypoint, 0);
}

static void reporting_a_plan_does_not_move_it_on(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    (void)rig_do(rig, COMMAND_HIL_LOAD_VUELO_ID);
    command_xplane_info_t info = rig_level_flight();
    (void)rig_fly(rig, &info);
    rig->board.hil.newest.latitude_deg = 27.960F; // at the first waypoint, before the next step
    rig->board.hil.newest.longitude_deg = -15.360F;
    assert_int_equal(hil_plan_of(rig).waypoint, 0);
    assert_int_equal(hil_plan_of(rig).distance_m, 0);
    assert_int_equal(rig->board.plans.plan[board_plan_hil].current, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_stream_is_sent_as_its_own_message),
        cmocka_unit_test(sensor_readings_come_through_unchanged),
        cmocka_unit_test(an_empty_plan_is_reported_as_no_data),
        cmocka_unit_test(without_a_position_a_plan_is_reported_but_for_the_way_to_its_waypoint),
        cmocka_unit_test(a_plan_is_reported_from_where_the_aircraft_is),
        cmocka_unit_test(reporting_a_plan_does_not_move_it_on),
    };
    return cmocka_run_group_tests_name("flight.board_streams", tests, NULL, NULL);
}

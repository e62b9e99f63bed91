#include "support/cmocka_all.h"

#include "common/limit.h"
#include "common/units.h"
#include "flight/board_sensors.h"
#include "navigation/geodesy.h"
#include "sim_board.h"

static const float sensor_period_s = 0.01F;
static const float cruise_kt = 60.0F;
static const int frame_ms = 20; ///< simulated time between two commands 50

/// An aircraft that flies straight to the north at 60 kt in calm air near sea level.
static command_xplane_info_t northbound(int flown_ms)
{
    const double way_m = (double)(cruise_kt * M_S_PER_KT) * (double)flown_ms / 1000.0;
    return (command_xplane_info_t){
        .altitude_ft = 100.0F,
        .speed_kt = cruise_kt,
        .latitude_deg = (float)(27.9319 + way_m / GEODESY_M_PER_DEG),
        .longitude_deg = -15.3866F,
    };
}

/// Fly for `seconds` of simulated time; the sensors are read `reads_per_frame[i]` times after frame i (again from the
/// beginning when the pattern ends). Returns the span of the speeds that the GPS put out after the first ten seconds.
static void fly(const sensors_t* sensors, int seconds, const int* reads_per_frame, int pattern, float span_kt[2])
{
    span_kt[0] = 10000.0F;
    span_kt[1] = 0.0F;
    for (int frame = 0; frame < seconds * 1000 / frame_ms; frame++)
    {
        const command_xplane_info_t info = northbound(frame * frame_ms);
        sensors->observe(sensors->context, &info, 0.5F);
        for (int i = 0; i < reads_per_frame[frame % pattern]; i++)
        {
            sensors_reading_t reading;
            sensors->read(sensors->context, sensor_period_s, &reading);
            if (frame * frame_ms >= 10000)
            {
                span_kt[0] = fminf(span_kt[0], reading.gps.speed_kt);
                span_kt[1] = fmaxf(span_kt[1], reading.gps.speed_kt);
            }
        }
    }
}

static void the_gps_tells_the_speed_of_the_flight(void** state)
{
    (void)state;
    static const int on_time[] = {2};
    const sensors_t sensors = sim_board_sensors(1);
    float span_kt[2];
    fly(&sensors, 20, on_time, 1, span_kt);
    assert_close(span_kt[0], cruise_kt, 1.5);
    assert_close(span_kt[1], cruise_kt, 1.5);
}

static void the_gps_tells_the_same_speed_when_the_board_gets_a_tenth_of_its_time(void** state)
{
    (void)state;
    // as in an emulated processor on a busy computer: two readings where twenty were due
    static const int starved[] = {0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const sensors_t sensors = sim_board_sensors(1);
    float span_kt[2];
    fly(&sensors, 60, starved, 10, span_kt);
    assert_close(span_kt[0], cruise_kt, 1.5);
    assert_close(span_kt[1], cruise_kt, 1.5);
}

static void the_gps_tells_the_same_speed_when_frames_come_in_bursts(void** state)
{
    (void)state;
    // 0.6 s of frames at once, then all the readings of that time
    static int bursts[30] = {0};
    bursts[29] = 60;
    const sensors_t sensors = sim_board_sensors(1);
    float span_kt[2];
    fly(&sensors, 60, bursts, 30, span_kt);
    assert_close(span_kt[0], cruise_kt, 1.5);
    assert_close(span_kt[1], cruise_kt, 1.5);
}

static void the_gps_stands_when_the_simulator_falls_silent(void** state)
{
    (void)state;
    static const int on_time[] = {2};
    const sensors_t sensors = sim_board_sensors(1);
    float span_kt[2];
    fly(&sensors, 15, on_time, 1, span_kt);
    sensors_reading_t reading;
    for (int i = 0; i < 300; i++)
    {
        sensors.read(sensors.context, sensor_period_s, &reading);
    }
    assert_true(reading.gps.speed_kt < 1.0F);
}

static void a_paused_simulator_turns_no_gyro_and_flies_on_afterwards(void** state)
{
    (void)state;
    const sensors_t sensors = sim_board_sensors(1);
    command_xplane_info_t info = northbound(0);
    info.gz_rad_s = 0.3F;
    sensors_reading_t reading;
    for (int frame = 0; frame < 500; frame++)
    {
        info.elevator = (float)(frame % 3) / 1000.0F; // a joystick trembles in a pause too
        sensors.observe(sensors.context, &info, 0.5F);
        for (int i = 0; i < 2; i++)
        {
            sensors.read(sensors.context, sensor_period_s, &reading);
        }
    }
    assert_close(reading.inertial.gz_rad_s, 0.0, 0.03);
    assert_close(reading.receiver.channel[rc_channel_elevator], 0.001, 0.01);
    info.latitude_deg += 0.00001F;
    sensors.observe(sensors.context, &info, 0.5F);
    for (int i = 0; i < 2; i++)
    {
        sensors.read(sensors.context, sensor_period_s, &reading);
    }
    assert_close(reading.inertial.gz_rad_s, 0.3, 0.03);
}

static void a_board_without_a_simulator_stands_on_the_runway(void** state)
{
    (void)state;
    const sensors_t sensors = sim_board_sensors(1);
    for (int i = 0; i < 500; i++)
    {
        sensors_reading_t reading;
        sensors.read(sensors.context, sensor_period_s, &reading);
        assert_true(reading.gps.speed_kt < 1.0F);
        assert_close(reading.gps.heading_deg, 28.0, 0.0);
        assert_close(reading.gps.latitude_deg, 27.9319, 0.001);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_board_without_a_simulator_stands_on_the_runway),
        cmocka_unit_test(the_gps_tells_the_speed_of_the_flight),
        cmocka_unit_test(the_gps_tells_the_same_speed_when_the_board_gets_a_tenth_of_its_time),
        cmocka_unit_test(the_gps_tells_the_same_speed_when_frames_come_in_bursts),
        cmocka_unit_test(the_gps_stands_when_the_simulator_falls_silent),
        cmocka_unit_test(a_paused_simulator_turns_no_gyro_and_flies_on_afterwards),
    };
    return cmocka_run_group_tests_name("models.sim_board", tests, NULL, NULL);
}

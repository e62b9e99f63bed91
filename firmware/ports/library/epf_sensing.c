#include "epf_sensing.h"

#include <math.h>

#include "app/sensing.h"
#include "sim_board.h"

static struct
{
    sensors_t sensors;
    estimator_t estimator;
    board_sensors_t readings;
} sensing;

void epf_sensing_start(uint32_t seed)
{
    sensing.sensors = sim_board_sensors(seed);
    estimator_init(&sensing.estimator);
}

void epf_sensing_observe(const uint8_t payload[COMMAND_XPLANE_INFO_SIZE], float throttle)
{
    command_xplane_info_t info;
    command_xplane_info_unpack(&info, payload);
    sensing.sensors.observe(sensing.sensors.context, &info, throttle);
}

void epf_sensing_step(float dt_s, uint32_t is_gyro_silent, epf_sensing_readings_t* readings)
{
    sensors_reading_t reading;
    sensing.sensors.read(sensing.sensors.context, dt_s, &reading);
    if (is_gyro_silent != 0U)
    {
        reading.inertial.gx_rad_s = NAN;
        reading.inertial.gy_rad_s = NAN;
        reading.inertial.gz_rad_s = NAN;
    }
    sensing_update(&sensing.estimator, &reading, dt_s, &sensing.readings);
    *readings = (epf_sensing_readings_t){sensing.readings.ahrs, sensing.readings.inertial, sensing.readings.analog};
}

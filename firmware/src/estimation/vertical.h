/// Altitude and vertical speed: the barometer's altitude, which the vertical acceleration makes respond faster.
#ifndef ESTIMATION_VERTICAL_H
#define ESTIMATION_VERTICAL_H

#include <stdbool.h>

/// What was measured in this step; the flag of a value that was not measured is false.
typedef struct
{
    float altitude_m; ///< pressure altitude
    bool has_altitude;
    float acceleration_m_s2; ///< upward, without gravity
    bool has_acceleration;
} vertical_input_t;

typedef struct
{
    float altitude_m;
    float speed_m_s;      ///< climb is positive
    float bias_m_s2;      ///< to be added to the measured acceleration
    float without_baro_s; ///< since the last altitude
    float disagreed_s;    ///< how long the barometer has been far from the estimate
    bool has_begun;
} vertical_filter_t;

void vertical_init(vertical_filter_t* filter);

/// One step of `dt_s` (> 0). Starts again from the barometer's altitude when the estimate stays far away from it.
void vertical_update(vertical_filter_t* filter, const vertical_input_t* input, float dt_s);

/// False before the first altitude and 2 s after the last one.
bool vertical_is_known(const vertical_filter_t* filter);

#endif

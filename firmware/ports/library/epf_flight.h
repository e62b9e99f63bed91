/// The board's pure code as a shared library, so that tests in other languages fly the same laws. No threads, no
/// clock: each command 50 advances the time by the HIL period, and so does `epf_flight_advance` by its argument.
#ifndef EPF_FLIGHT_H
#define EPF_FLIGHT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct flight flight_t;

enum
{
    epf_flight_channels = 12, ///< of the receiver
    epf_flight_servos = 20
};

/// What the real aircraft's loop is flown by; NaN: not measured. A GPS without a latitude has no fix.
typedef struct
{
    float p_rad_s;
    float q_rad_s;
    float r_rad_s;
    float yaw_deg;
    float pitch_deg;
    float roll_deg;
    float altitude_m;
    float vvi_ft_min;
    float calibrated_airspeed_kt;
    float gps_latitude_deg;
    float gps_longitude_deg;
    float gps_altitude_m;
    float gps_speed_kt;
    float gps_heading_deg;
    float channel[epf_flight_channels];
} epf_flight_readings_t;

/// A board in binary mode as after power-on, without a card. `hil_period_s` > 0 is the time of each HIL step; 0: the
/// time by which `epf_flight_advance` was called between two commands 50. NULL without memory.
flight_t* epf_flight_new(float hil_period_s);

void epf_flight_free(flight_t* flight);

/// Feed `size` bytes of the line, in chunks of any size, and return what the board sends, up to `capacity` bytes;
/// the rest comes with the next call (`size` may be 0). Returns the bytes written to `out`.
size_t epf_flight_feed(flight_t* flight, const uint8_t* in, size_t size, uint8_t* out, size_t capacity);

/// Advance the time by `elapsed_ms` and do what is due by the clock: status, a plan being read back, and what the
/// failsafe of a silent simulator says.
void epf_flight_advance(flight_t* flight, uint32_t elapsed_ms);

/// Send the streams of one task that are on: 0 parameters, 1 FMS, 2 servos.
void epf_flight_send_streams(flight_t* flight, uint32_t task);

/// See whether command 50 has stopped, as the board's control task does each 20 ms.
void epf_flight_supervise(flight_t* flight);

/// One step of the real aircraft's loop, `dt_s` (> 0) after the last. The time of the line is left alone.
void epf_flight_step(flight_t* flight, const epf_flight_readings_t* readings, float dt_s);

/// The position of every servo output, -1..+1 (throttle 0..1).
void epf_flight_positions(const flight_t* flight, float positions[epf_flight_servos]);

/// Bytes that were lost because the queue was full; a test should check that it is 0.
size_t epf_flight_lost_bytes(const flight_t* flight);

#endif

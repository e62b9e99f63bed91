/// The board's pure code as a shared library, so that tests in other languages fly the same laws. No threads, no
/// clock: each command 50 advances the time by the HIL period, and so does `epf_flight_advance` by its argument.
#ifndef EPF_FLIGHT_H
#define EPF_FLIGHT_H

#include <stddef.h>
#include <stdint.h>

typedef struct flight flight_t;

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

/// Bytes that were lost because the queue was full; a test should check that it is 0.
size_t epf_flight_lost_bytes(const flight_t* flight);

#endif

/// The board's pure code as a shared library, so that tests in other languages fly the very same laws. No threads, no
/// clock: time passes by the HIL period with each command 50, or by `epf_flight_advance`.
#ifndef EPF_FLIGHT_H
#define EPF_FLIGHT_H

#include <stddef.h>
#include <stdint.h>

typedef struct flight flight_t;

/// A board in binary mode as after power-on, without a card. `hil_period_s` > 0 is the time of each HIL step; 0 takes
/// the time that `epf_flight_advance` lets pass between two commands 50. NULL without memory.
flight_t* epf_flight_new(float hil_period_s);

void epf_flight_free(flight_t* flight);

/// Feed `size` bytes of the line, in chunks of any size, and take what the board sends, as far as `capacity` allows;
/// the rest comes with the next call (`size` may be 0). Returns the bytes written to `out`.
size_t epf_flight_feed(flight_t* flight, const uint8_t* in, size_t size, uint8_t* out, size_t capacity);

/// Let `elapsed_ms` pass and send what a board sends by itself then: status, a plan being read back.
void epf_flight_advance(flight_t* flight, uint32_t elapsed_ms);

/// Send the streams of one task that are on: 0 parameters, 1 FMS, 2 servos.
void epf_flight_send_streams(flight_t* flight, uint32_t task);

/// Bytes that were lost because nobody took them: 0 in a sound test.
size_t epf_flight_lost_bytes(const flight_t* flight);

#endif

/// Little-endian values in byte buffers, one byte at a time: no alignment and no host order is assumed.
#ifndef COMMON_BYTES_H
#define COMMON_BYTES_H

#include <stdint.h>

uint32_t bytes_read_u32(const uint8_t* bytes);
void bytes_write_u32(uint8_t* bytes, uint32_t value);
float bytes_read_f32(const uint8_t* bytes);
void bytes_write_f32(uint8_t* bytes, float value);
double bytes_read_f64(const uint8_t* bytes);
void bytes_write_f64(uint8_t* bytes, double value);

#endif

/// The two checksums of an SD card's line (Physical Layer Simplified Specification, 4.5).
#ifndef SDCARD_SD_CRC_H
#define SDCARD_SD_CRC_H

#include <stddef.h>
#include <stdint.h>

/// Of a command: seven bits (polynomial x7+x3+1), followed by the 1 bit that ends the command.
uint8_t sd_crc7(const uint8_t* bytes, size_t size);

/// Of a block of data: x16+x12+x5+1, beginning with 0.
uint16_t sd_crc16(const uint8_t* bytes, size_t size);

#endif

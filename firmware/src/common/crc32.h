/// CRC-32 (IEEE 802.3, reflected, polynomial 0xEDB88320), as used by zip and Ethernet.
#ifndef COMMON_CRC32_H
#define COMMON_CRC32_H

#include <stddef.h>
#include <stdint.h>

/// CRC of `size` bytes. The CRC of the nine characters "123456789" is 0xCBF43926.
uint32_t crc32_of(const uint8_t* bytes, size_t size);

/// CRC of what has the CRC `before` (0: of nothing), with `size` bytes after it.
uint32_t crc32_with(uint32_t before, const uint8_t* bytes, size_t size);

#endif

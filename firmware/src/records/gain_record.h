/// The board's own gains as a record of the card: values by name, so that firmware with other gains takes those that it
/// knows. A name is kept as its CRC-32.
#ifndef RECORDS_GAIN_RECORD_H
#define RECORDS_GAIN_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/storage.h"
#include "records/record.h"

enum
{
    gain_record_gain_bytes = 8 ///< name, value
};

/// Load the stored gains into `room` of `capacity` bytes. `record_whole` with their number in `*count`.
record_state_t gain_record_load(const storage_t* storage, uint8_t* room, size_t capacity, size_t* count);

/// Find a gain by its name among the `count` that were loaded. False, and nothing changed, where it is not kept.
bool gain_record_find(const uint8_t* room, size_t count, const char* name, float* value);

/// Put gain `index` into `room` for `gain_record_save`. Returns how many bytes the gains up to it are.
size_t gain_record_put(uint8_t* room, size_t index, const char* name, float value);

/// Write the gains that were put into `room` to the card. What is in `room` is overwritten.
record_state_t gain_record_save(const storage_t* storage, uint8_t* room, size_t capacity, size_t taken);

#endif

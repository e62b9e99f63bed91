/// The parameter set as a record of the card. Version 1 was written to `params.a` and `params.b` by turns; it is read
/// where there is no newer record, and the next store writes the present version.
#ifndef RECORDS_PARAMETER_RECORD_H
#define RECORDS_PARAMETER_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/storage.h"
#include "params/parameters.h"
#include "records/record.h"

enum
{
    parameter_record_bytes = record_frame_bytes + 4 + 4 * parameters_count ///< count, values
};

/// Whether the card can be read at all. A broken card may block this call for seconds.
bool parameter_record_card_answers(const storage_t* storage);

/// Load the stored set. Nothing is changed unless `record_whole` comes back. `room` holds `capacity` bytes, of which
/// at least `parameter_record_bytes` are needed.
record_state_t parameter_record_load(const storage_t* storage, parameters_t* parameters, uint8_t* room,
                                     size_t capacity);

/// Copy the set into `room` for `parameter_record_save`; returns how many bytes it is.
size_t parameter_record_take(const parameters_t* parameters, uint8_t* room);

/// Write the set that was copied to the card. What is in `room` is overwritten.
record_state_t parameter_record_save(const storage_t* storage, uint8_t* room, size_t capacity, size_t taken);

#endif

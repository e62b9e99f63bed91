/// The parameter set on the card: two slots written in turn, so that one whole set survives a power cut at any moment.
#ifndef PARAMS_PARAMETER_STORE_H
#define PARAMS_PARAMETER_STORE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/storage.h"
#include "params/parameters.h"

enum
{
    parameter_record_bytes = 16 + 4 * parameters_count + 4 ///< magic, version, sequence, count; values; CRC-32
};

/// Write a set as a record of `parameter_record_bytes`.
void parameter_record_write(uint8_t* bytes, const parameters_t* parameters, uint32_t sequence);

/// Read a record; false, and nothing changed, when anything in it is wrong (length, magic, version, CRC, a value).
bool parameter_record_read(const uint8_t* bytes, size_t size, parameters_t* parameters, uint32_t* sequence);

/// Load the newest whole set. `storage_missing` (and nothing changed) when no slot holds one.
storage_status_t parameter_store_load(const storage_t* storage, parameters_t* parameters);

/// Store a set over the older or broken slot and read it back.
storage_status_t parameter_store_save(const storage_t* storage, const parameters_t* parameters);

#endif

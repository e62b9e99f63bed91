/// Small whole files on a device of blocks, by littlefs. The device is mounted for each call and unmounted afterwards,
/// so that the card may be exchanged between two calls.
#ifndef VOLUME_VOLUME_H
#define VOLUME_VOLUME_H

#include <stdint.h>

#include <lfs.h>

#include "hal/block_device.h"
#include "hal/storage.h"

enum
{
    volume_cache_bytes = 512,   ///< a multiple of the device's `program_bytes`, and a part of its `block_bytes`
    volume_lookahead_bytes = 16 ///< one bit for each block that is searched for a free one
};

/// Private to volume.c except `storage`.
typedef struct
{
    lfs_t filesystem;
    struct lfs_config config;
    struct lfs_file_config file_config;
    const block_device_t* device;
    const storage_t* older;
    uint8_t read_buffer[volume_cache_bytes];
    uint8_t program_buffer[volume_cache_bytes];
    uint8_t file_buffer[volume_cache_bytes];
    uint8_t lookahead_buffer[volume_lookahead_bytes];
    storage_t storage; ///< the files, for whoever uses them; one caller at a time
} volume_t;

/// Files on `device`. A device that never held anything has no files and is formatted by the first `replace`; so is one
/// on which nothing can be read any more. A device that does not answer, or that another version of littlefs or of this
/// board's layout wrote, is left as it is, and every call fails. A file that is not on the device, or that cannot be
/// found because nothing there can be read, is read from `older` (NULL: nowhere), where boards kept their files before.
/// This call writes nothing.
void volume_init(volume_t* volume, const block_device_t* device, const storage_t* older);

#endif

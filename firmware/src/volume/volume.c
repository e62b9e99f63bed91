#include "volume/volume.h"

#include <stdbool.h>
#include <string.h>

enum
{
    wear_cycles = 500 ///< writes of a block of names, after which littlefs moves it elsewhere
};

static const char staged_name[] = "staged"; ///< name of a file while it is written; it gets its own name when complete

static const block_device_t* device_of(const struct lfs_config* config)
{
    const volume_t* const volume = config->context;
    return volume->device;
}

static int error_of(block_status_t status)
{
    switch (status)
    {
    case block_ok:
        return LFS_ERR_OK;
    case block_worn:
        return LFS_ERR_CORRUPT;
    case block_failed:
        break;
    }
    return LFS_ERR_IO;
}

static int read_block(const struct lfs_config* config, lfs_block_t block, lfs_off_t offset, void* data, lfs_size_t size)
{
    const block_device_t* const device = device_of(config);
    return error_of(device->read(device->context, block, offset, data, size));
}

static int program_block(const struct lfs_config* config, lfs_block_t block, lfs_off_t offset, const void* data,
                         lfs_size_t size)
{
    const block_device_t* const device = device_of(config);
    return error_of(device->program(device->context, block, offset, data, size));
}

static int erase_block(const struct lfs_config* config, lfs_block_t block)
{
    const block_device_t* const device = device_of(config);
    return error_of(device->erase(device->context, block));
}

static int sync_device(const struct lfs_config* config)
{
    const block_device_t* const device = device_of(config);
    return error_of(device->sync(device->context));
}

/// True when the two blocks in which littlefs begins hold nothing, as on a device that was never written.
static bool is_blank(volume_t* volume)
{
    const block_device_t* const device = volume->device;
    uint8_t* const bytes = volume->read_buffer; // free while nothing is mounted
    uint32_t ones = 0U;
    uint32_t zeros = 0U;
    for (uint32_t block = 0U; block < 2U; block++)
    {
        for (uint32_t offset = 0U; offset < device->block_bytes; offset += (uint32_t)volume_cache_bytes)
        {
            if (device->read(device->context, block, offset, bytes, volume_cache_bytes) != block_ok)
            {
                return false;
            }
            for (size_t i = 0U; i < (size_t)volume_cache_bytes; i++)
            {
                ones |= bytes[i];
                zeros |= (uint32_t)bytes[i] ^ 0xFFU;
            }
        }
    }
    return ones == 0U || zeros == 0U;
}

/// Mount the device as it is.
static int mount(volume_t* volume)
{
    const block_device_t* const device = volume->device;
    if (device->begin != NULL && device->begin(device->context) != block_ok)
    {
        return LFS_ERR_IO;
    }
    return lfs_mount(&volume->filesystem, &volume->config);
}

static storage_status_t mount_to_read(volume_t* volume)
{
    const int error = mount(volume);
    if (error == LFS_ERR_CORRUPT && is_blank(volume))
    {
        return storage_missing;
    }
    return error == LFS_ERR_OK ? storage_ok : storage_failed;
}

/// Format a device only if it holds nothing, or nothing that can be read.
static bool mount_to_write(volume_t* volume)
{
    int error = mount(volume);
    if (error == LFS_ERR_CORRUPT)
    {
        error = lfs_format(&volume->filesystem, &volume->config);
        if (error == LFS_ERR_OK)
        {
            error = lfs_mount(&volume->filesystem, &volume->config);
        }
    }
    return error == LFS_ERR_OK;
}

static storage_status_t status_of(int error)
{
    if (error == LFS_ERR_NOENT)
    {
        return storage_missing;
    }
    return error < 0 ? storage_failed : storage_ok;
}

/// Read a file of the mounted volume.
static storage_status_t read_mounted(volume_t* volume, const char* name, uint8_t* data, size_t capacity, size_t* size)
{
    lfs_file_t file;
    const int opened = lfs_file_opencfg(&volume->filesystem, &file, name, LFS_O_RDONLY, &volume->file_config);
    if (opened != LFS_ERR_OK)
    {
        return status_of(opened);
    }
    const lfs_soff_t length = lfs_file_size(&volume->filesystem, &file);
    const lfs_ssize_t count = lfs_file_read(&volume->filesystem, &file, data, (lfs_size_t)capacity);
    const int closed = lfs_file_close(&volume->filesystem, &file);
    if (length < 0 || count < 0 || closed != LFS_ERR_OK)
    {
        return storage_failed;
    }
    *size = (size_t)count;
    return (size_t)length > capacity ? storage_too_long : storage_ok;
}

/// Write a file of the mounted volume: when the new file is complete, it takes the old one's name in a single step.
static bool replace_mounted(volume_t* volume, const char* name, const uint8_t* data, size_t size)
{
    lfs_t* const filesystem = &volume->filesystem;
    lfs_file_t file;
    if (lfs_file_opencfg(filesystem, &file, staged_name, LFS_O_WRONLY | LFS_O_CREAT | LFS_O_TRUNC,
                         &volume->file_config) != LFS_ERR_OK)
    {
        return false;
    }
    const lfs_ssize_t written = lfs_file_write(filesystem, &file, data, (lfs_size_t)size);
    const int closed = lfs_file_close(filesystem, &file);
    // What a failed call leaves of it, the next call overwrites.
    return written == (lfs_ssize_t)size && closed == LFS_ERR_OK &&
           lfs_rename(filesystem, staged_name, name) == LFS_ERR_OK;
}

static storage_status_t read_file(void* context, const char* name, uint8_t* data, size_t capacity, size_t* size)
{
    volume_t* const volume = context;
    *size = 0U;
    storage_status_t status = mount_to_read(volume);
    if (status == storage_ok)
    {
        status = read_mounted(volume, name, data, capacity, size);
        if (lfs_unmount(&volume->filesystem) != LFS_ERR_OK)
        {
            status = storage_failed;
        }
    }
    if ((status == storage_missing || status == storage_failed) && volume->older != NULL)
    {
        // Also after a power cut during the formatting: the older file still exists.
        const storage_status_t older = volume->older->read(volume->older->context, name, data, capacity, size);
        status = older == storage_missing ? status : older;
    }
    return status;
}

static storage_status_t replace_file(void* context, const char* name, const uint8_t* data, size_t size)
{
    volume_t* const volume = context;
    if (!mount_to_write(volume))
    {
        return storage_failed;
    }
    const bool replaced = replace_mounted(volume, name, data, size);
    const bool let_go = lfs_unmount(&volume->filesystem) == LFS_ERR_OK;
    const block_device_t* const device = volume->device;
    const bool kept = device->sync(device->context) == block_ok;
    return replaced && let_go && kept ? storage_ok : storage_failed;
}

void volume_init(volume_t* volume, const block_device_t* device, const storage_t* older)
{
    memset(volume, 0, sizeof *volume);
    volume->device = device;
    volume->older = older;
    volume->config = (struct lfs_config){
        .context = volume,
        .read = read_block,
        .prog = program_block,
        .erase = erase_block,
        .sync = sync_device,
        .read_size = device->program_bytes,
        .prog_size = device->program_bytes,
        .block_size = device->block_bytes,
        .block_count = device->block_count,
        .block_cycles = wear_cycles,
        .cache_size = volume_cache_bytes,
        .lookahead_size = volume_lookahead_bytes,
        .read_buffer = volume->read_buffer,
        .prog_buffer = volume->program_buffer,
        .lookahead_buffer = volume->lookahead_buffer,
    };
    volume->file_config = (struct lfs_file_config){.buffer = volume->file_buffer};
    volume->storage = (storage_t){.context = volume, .read = read_file, .replace = replace_file};
}

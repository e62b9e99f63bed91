#define _POSIX_C_SOURCE 200809L

#include "card_image.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

#include "card_layout.h"

enum
{
    path_bytes = 4096
};

static const int nowhere = -1; ///< no image yet
static int image = nowhere;

static off_t place_of(uint32_t block, uint32_t offset)
{
    return (off_t)block * card_layout_block_bytes + (off_t)offset;
}

/// Blocks beyond the image's end were never written: they read as 0xFF.
static block_status_t read_image(void* context, uint32_t block, uint32_t offset, uint8_t* data, size_t size)
{
    (void)context;
    memset(data, 0xFF, size);
    size_t held = 0;
    while (image != nowhere && held < size)
    {
        const ssize_t count = pread(image, data + held, size - held, place_of(block, offset) + (off_t)held);
        if (count < 0)
        {
            return block_failed;
        }
        if (count == 0)
        {
            break;
        }
        held += (size_t)count;
    }
    return block_ok;
}

static block_status_t program_image(void* context, uint32_t block, uint32_t offset, const uint8_t* data, size_t size)
{
    (void)context;
    size_t written = 0;
    while (written < size)
    {
        const ssize_t count = pwrite(image, data + written, size - written, place_of(block, offset) + (off_t)written);
        if (count <= 0)
        {
            return block_failed;
        }
        written += (size_t)count;
    }
    return block_ok;
}

static block_status_t erase_image(void* context, uint32_t block)
{
    uint8_t blank[card_layout_block_bytes];
    memset(blank, 0xFF, sizeof blank);
    return program_image(context, block, 0, blank, sizeof blank);
}

static block_status_t sync_image(void* context)
{
    (void)context;
    return fsync(image) == 0 ? block_ok : block_failed;
}

const block_device_t* card_image_device(void)
{
    static const block_device_t device = {
        .context = NULL,
        .block_bytes = card_layout_block_bytes,
        .block_count = card_layout_blocks,
        .program_bytes = card_layout_program_bytes,
        .read = read_image,
        .program = program_image,
        .erase = erase_image,
        .sync = sync_image,
    };
    return &device;
}

/// Write the folder to the disk too, because the image's name is stored there.
static bool sync_folder(const char* path)
{
    const int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const bool done = folder >= 0 && fsync(folder) == 0;
    if (folder >= 0)
    {
        (void)close(folder);
    }
    return done;
}

bool card_image_open(const char* folder, bool for_writing)
{
    char path[path_bytes];
    const int length = snprintf(path, sizeof path, "%s/%s", folder, CARD_LAYOUT_IMAGE);
    if (length <= 0 || (size_t)length >= sizeof path)
    {
        return false;
    }
    image = open(path, for_writing ? O_RDWR | O_CLOEXEC : O_RDONLY | O_CLOEXEC);
    if (image >= 0 || errno != ENOENT || !for_writing)
    {
        return image >= 0 || errno == ENOENT;
    }
    image = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    return image >= 0 && sync_folder(folder);
}

void card_image_close(void)
{
    if (image >= 0)
    {
        (void)close(image);
    }
    image = nowhere;
}

#include "host_card.h"

#include <stdbool.h>
#include <string.h>

#include "card_layout.h"
#include "semihosting.h"
#include "volume/volume.h"

static const int32_t nowhere = -1;

static struct
{
    const char* folder;
    int32_t image; ///< handle of the file; negative: it does not exist yet
    volume_t volume;
    storage_t storage;
} card;

static bool path_of(const char* name, const char* ending, char path[semihosting_path_bytes])
{
    const size_t folder_length = strlen(card.folder);
    const size_t name_length = strlen(name);
    const size_t ending_length = strlen(ending);
    if (folder_length + 1U + name_length + ending_length + 1U > (size_t)semihosting_path_bytes)
    {
        return false;
    }
    memcpy(path, card.folder, folder_length);
    path[folder_length] = '/';
    memcpy(path + folder_length + 1U, name, name_length);
    memcpy(path + folder_length + 1U + name_length, ending, ending_length + 1U);
    return true;
}

/// Open the image; create it when something is to be written and it does not exist.
static bool open_image(bool for_writing)
{
    char path[semihosting_path_bytes];
    if (card.image < 0 && path_of(CARD_LAYOUT_IMAGE, "", path))
    {
        card.image = semihosting_open_file(path, semihosting_mode_change);
        if (card.image < 0 && for_writing)
        {
            card.image = semihosting_open_file(path, semihosting_mode_make);
        }
    }
    return card.image >= 0;
}

static bool seek(uint32_t block, uint32_t offset)
{
    const uint32_t arguments[] = {(uint32_t)card.image, block * (uint32_t)card_layout_block_bytes + offset};
    return semihosting_ask(semihosting_seek, arguments) == 0;
}

/// Blocks beyond the image's end were never written: they read as 0xFF.
static block_status_t read_image(void* context, uint32_t block, uint32_t offset, uint8_t* data, size_t size)
{
    (void)context;
    memset(data, 0xFF, size);
    if (!open_image(false))
    {
        return block_ok;
    }
    const int32_t length = semihosting_of(semihosting_length, card.image);
    const uint32_t place = block * (uint32_t)card_layout_block_bytes + offset;
    if (length < 0)
    {
        return block_failed;
    }
    if (place >= (uint32_t)length)
    {
        return block_ok;
    }
    const size_t there = (size_t)length - (size_t)place;
    const size_t wanted = there < size ? there : size;
    return seek(block, offset) && semihosting_move(semihosting_read, card.image, data, wanted) ? block_ok
                                                                                               : block_failed;
}

static block_status_t program_image(void* context, uint32_t block, uint32_t offset, const uint8_t* data, size_t size)
{
    (void)context;
    return open_image(true) && seek(block, offset) && semihosting_move(semihosting_write, card.image, data, size)
               ? block_ok
               : block_failed;
}

static block_status_t erase_image(void* context, uint32_t block)
{
    uint8_t blank[64];
    memset(blank, 0xFF, sizeof blank);
    block_status_t status = block_ok;
    for (uint32_t offset = 0U; offset < (uint32_t)card_layout_block_bytes && status == block_ok; offset += sizeof blank)
    {
        status = program_image(context, block, offset, blank, sizeof blank);
    }
    return status;
}

/// Nothing to do: the emulator passes each write on at once.
static block_status_t sync_image(void* context)
{
    (void)context;
    return block_ok;
}

/// Read a record as earlier boards kept it: in a file of its own beside the card's image.
static storage_status_t read_older(void* context, const char* name, uint8_t* data, size_t capacity, size_t* size)
{
    (void)context;
    *size = 0U;
    char path[semihosting_path_bytes];
    const int32_t file = path_of(name, "", path) ? semihosting_open_file(path, semihosting_mode_read) : nowhere;
    if (file < 0)
    {
        return storage_missing;
    }
    const int32_t length = semihosting_of(semihosting_length, file);
    const bool is_long = length >= 0 && (size_t)length > capacity;
    const size_t wanted = is_long ? capacity : (size_t)length;
    const bool is_read = length >= 0 && semihosting_move(semihosting_read, file, data, wanted);
    const bool is_closed = semihosting_of(semihosting_close, file) == 0;
    if (!is_read || !is_closed)
    {
        return storage_failed;
    }
    *size = wanted;
    return is_long ? storage_too_long : storage_ok;
}

/// Remove the older files of a record that is in the image now: it must not reappear if the image is damaged later.
static void remove_older(const char* name)
{
    static const char* const endings[] = CARD_LAYOUT_OLDER_ENDINGS;
    for (size_t i = 0U; i < sizeof endings / sizeof endings[0]; i++)
    {
        char path[semihosting_path_bytes];
        if (path_of(name, endings[i], path))
        {
            const uint32_t arguments[] = {semihosting_address(path), (uint32_t)strlen(path)};
            (void)semihosting_ask(semihosting_remove, arguments); // fails when there is none, the usual case
        }
    }
}

static storage_status_t replace_file(void* context, const char* name, const uint8_t* data, size_t size)
{
    (void)context;
    const storage_t* const files = &card.volume.storage;
    const storage_status_t status = files->replace(files->context, name, data, size);
    if (status == storage_ok)
    {
        remove_older(name);
    }
    return status;
}

const storage_t* host_card_in(const char* folder)
{
    static const block_device_t device = {
        .block_bytes = card_layout_block_bytes,
        .block_count = card_layout_blocks,
        .program_bytes = card_layout_program_bytes,
        .read = read_image,
        .program = program_image,
        .erase = erase_image,
        .sync = sync_image,
    };
    static const storage_t older = {.context = NULL, .read = read_older, .replace = NULL};
    card.folder = folder;
    card.image = nowhere;
    volume_init(&card.volume, &device, &older);
    card.storage = card.volume.storage;
    card.storage.replace = replace_file;
    return &card.storage;
}

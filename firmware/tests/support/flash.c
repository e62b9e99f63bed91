#include "support/flash.h"

#include <string.h>

static block_status_t read_flash(void* context, uint32_t block, uint32_t offset, uint8_t* data, size_t size)
{
    const flash_t* const flash = context;
    if (flash->is_off || flash->cannot_read || block >= (uint32_t)flash_blocks || offset + size > flash_block_bytes)
    {
        return block_failed;
    }
    memcpy(data, flash->bytes[block] + offset, size);
    return block_ok;
}

/// How many of `size` bytes this write reaches; the power is cut in it when it is time for that.
static size_t reach(flash_t* flash, size_t size)
{
    flash->writes++;
    if (flash->writes_until_cut < 0)
    {
        return size;
    }
    if (flash->writes_until_cut > 0)
    {
        flash->writes_until_cut--;
        return size;
    }
    flash->is_off = true;
    switch (flash->cut)
    {
    case flash_cut_within:
        return size / 2;
    case flash_cut_after:
        return size;
    case flash_cut_before:
    case flash_cut_count:
        break;
    }
    return 0;
}

/// In pieces of `unit` bytes, between which the power can be cut.
static block_status_t write_flash(flash_t* flash, uint32_t block, uint32_t offset, const uint8_t* data, size_t size,
                                  size_t unit)
{
    if (flash->is_off || flash->cannot_write || block >= (uint32_t)flash_blocks || offset + size > flash_block_bytes)
    {
        return block_failed;
    }
    if (flash->is_worn[block])
    {
        return block_worn;
    }
    for (size_t at = 0; !flash->is_stuck[block] && !flash->is_off && at < size; at += unit)
    {
        memcpy(flash->bytes[block] + offset + at, data + at, reach(flash, unit));
    }
    return flash->is_off ? block_failed : block_ok;
}

static block_status_t program_flash(void* context, uint32_t block, uint32_t offset, const uint8_t* data, size_t size)
{
    flash_t* const flash = context;
    for (size_t i = 0; i < size && block < (uint32_t)flash_blocks && !flash->is_stuck[block]; i++)
    {
        flash->written_twice += flash->bytes[block][offset + i] != 0xFFU ? 1 : 0;
    }
    return write_flash(flash, block, offset, data, size, flash_program_bytes);
}

static block_status_t erase_flash(void* context, uint32_t block)
{
    uint8_t blank[flash_block_bytes];
    memset(blank, 0xFF, sizeof blank);
    return write_flash(context, block, 0, blank, sizeof blank, sizeof blank);
}

static block_status_t sync_flash(void* context)
{
    const flash_t* const flash = context;
    return flash->is_off ? block_failed : block_ok;
}

void flash_init(flash_t* flash)
{
    memset(flash, 0, sizeof *flash);
    memset(flash->bytes, 0xFF, sizeof flash->bytes);
    flash->device = (block_device_t){
        .context = flash,
        .block_bytes = flash_block_bytes,
        .block_count = flash_blocks,
        .program_bytes = flash_program_bytes,
        .read = read_flash,
        .program = program_flash,
        .erase = erase_flash,
        .sync = sync_flash,
    };
    flash_restart(flash);
}

void flash_restart(flash_t* flash)
{
    flash->is_off = false;
    flash->writes = 0;
    flash->writes_until_cut = -1;
    volume_init(&flash->volume, &flash->device, NULL);
}

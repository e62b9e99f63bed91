#include "host.h"

#include <stddef.h>

#include "card_layout.h"
#include "machine.h"
#include "sdcard/sd_card.h"
#include "volume/volume.h"

const uint32_t host_patience = 1;

const storage_t* host_card(void)
{
    static sd_card_t card;
    static volume_t volume;
    const spi_t* const bus = machine_card_bus();
    if (bus == NULL)
    {
        return NULL;
    }
    sd_card_init(&card, bus, card_layout_block_bytes, card_layout_blocks);
    volume_init(&volume, &card.device, NULL);
    return &volume.storage;
}

bool host_has_option(const char* option)
{
    (void)option;
    return false;
}

const char* host_word_after(const char* option)
{
    (void)option;
    return NULL;
}

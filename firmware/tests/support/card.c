#include "support/card.h"

#include <string.h>

card_file_t* card_find(card_t* card, const char* name)
{
    for (size_t i = 0; i < card->count; i++)
    {
        if (strcmp(card->files[i].name, name) == 0)
        {
            return &card->files[i];
        }
    }
    return NULL;
}

static storage_status_t read_file(void* context, const char* name, uint8_t* data, size_t capacity, size_t* size)
{
    card_t* const card = context;
    if (card->has_failed || card->power_is_cut)
    {
        return storage_failed;
    }
    const card_file_t* const file = card_find(card, name);
    if (file == NULL)
    {
        return storage_missing;
    }
    if (file->size > capacity)
    {
        return storage_failed;
    }
    memcpy(data, file->data, file->size);
    *size = file->size;
    return storage_ok;
}

/// The worst that a card may do: the file is emptied first, then written byte by byte.
static storage_status_t replace_file(void* context, const char* name, const uint8_t* data, size_t size)
{
    card_t* const card = context;
    if (card->has_failed || card->power_is_cut || size > card_file_bytes)
    {
        return storage_failed;
    }
    if (card->lies)
    {
        return storage_ok;
    }
    card_file_t* file = card_find(card, name);
    if (file == NULL)
    {
        if (card->count == card_files_max || strlen(name) >= card_name_bytes)
        {
            return storage_failed;
        }
        file = &card->files[card->count++];
        memcpy(file->name, name, strlen(name) + 1);
    }
    file->size = 0;
    for (size_t i = 0; i < size; i++)
    {
        if (card->bytes_until_cut == 0)
        {
            card->power_is_cut = true;
            return storage_failed;
        }
        card->bytes_until_cut -= card->bytes_until_cut > 0 ? 1 : 0;
        file->data[i] = data[i];
        file->size = i + 1;
    }
    return storage_ok;
}

void card_init(card_t* card)
{
    memset(card, 0, sizeof *card);
    card->bytes_until_cut = -1;
    card->storage = (storage_t){.context = card, .read = read_file, .replace = replace_file};
}

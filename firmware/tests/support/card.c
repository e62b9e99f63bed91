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
    *size = 0;
    if (card->has_failed)
    {
        return storage_failed;
    }
    const card_file_t* const file = card_find(card, name);
    if (file == NULL)
    {
        return storage_missing;
    }
    *size = file->size > capacity ? capacity : file->size;
    memcpy(data, file->data, *size);
    return file->size > capacity ? storage_too_long : storage_ok;
}

static storage_status_t replace_file(void* context, const char* name, const uint8_t* data, size_t size)
{
    card_t* const card = context;
    if (card->has_failed || card->cannot_write || size > card_file_bytes)
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
    memcpy(file->data, data, size);
    file->size = size;
    return storage_ok;
}

void card_init(card_t* card)
{
    memset(card, 0, sizeof *card);
    card->storage = (storage_t){.context = card, .read = read_file, .replace = replace_file};
}

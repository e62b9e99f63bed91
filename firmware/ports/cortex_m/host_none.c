#include "host.h"

#include <stddef.h>

const uint32_t host_patience = 1;

const storage_t* host_card(void)
{
    return NULL;
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

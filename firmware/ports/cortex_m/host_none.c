#include "host.h"

#include <stddef.h>

const storage_t* host_card(void)
{
    return NULL;
}

bool host_has_option(const char* option)
{
    (void)option;
    return false;
}

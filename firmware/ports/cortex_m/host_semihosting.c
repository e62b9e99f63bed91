// By Arm's semihosting, for images under an emulator only. The emulator's arguments are the board's options, of which
// `--card FOLDER` must be the last.
#include "host.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "host_card.h"
#include "semihosting.h"

enum
{
    word_bytes = 24,
    folder_bytes = 256,
    line_bytes = folder_bytes + 64
};

const uint32_t host_patience = 5;

static const char card_option[] = "--card ";

static char folder[folder_bytes];

/// The emulator's arguments, separated by blanks; empty when there are none.
static const char* command_line(void)
{
    static char line[line_bytes];
    const uint32_t arguments[] = {semihosting_address(line), line_bytes - 1U};
    if (semihosting_ask(semihosting_command_line, arguments) != 0)
    {
        line[0] = '\0';
    }
    return line;
}

const storage_t* host_card(void)
{
    const char* const found = strstr(command_line(), card_option);
    if (found == NULL)
    {
        return NULL;
    }
    const char* const name = found + sizeof card_option - 1U;
    const size_t length = strlen(name);
    if (length == 0U || length >= folder_bytes)
    {
        return NULL;
    }
    memcpy(folder, name, length + 1U);
    return host_card_in(folder);
}

/// Find the option in `line`; NULL when it is missing. Everything after `--card` is the folder's name, not an option.
static const char* find_option(const char* line, const char* option)
{
    const char* const card = strstr(line, card_option);
    const char* const found = strstr(line, option);
    return found != NULL && (card == NULL || found < card) ? found : NULL;
}

bool host_has_option(const char* option)
{
    return find_option(command_line(), option) != NULL;
}

const char* host_word_after(const char* option)
{
    static char word[word_bytes];
    const char* const found = find_option(command_line(), option);
    if (found == NULL)
    {
        return NULL;
    }
    const char* const begin = found + strlen(option) + 1U;
    const size_t length = strcspn(begin, " ");
    if (length == 0U || length >= word_bytes)
    {
        return NULL;
    }
    memcpy(word, begin, length);
    word[length] = '\0';
    return word;
}

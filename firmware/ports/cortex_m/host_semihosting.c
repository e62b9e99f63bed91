// By Arm's semihosting: for images under an emulator only, as the call is a fault on a processor without a debugger.
// The emulator's arguments are the board's options; `--card FOLDER` is the last of them.
#include "host.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

// Operations and open modes of "Semihosting for AArch32 and AArch64".
enum
{
    semihosting_open = 0x01,
    semihosting_close = 0x02,
    semihosting_write = 0x05,
    semihosting_read = 0x06,
    semihosting_length = 0x0C,
    semihosting_rename = 0x0F,
    semihosting_command_line = 0x15,
    semihosting_mode_read = 1,
    semihosting_mode_write = 5
};

enum
{
    word_bytes = 24,
    folder_bytes = 256,
    line_bytes = folder_bytes + 64,
    path_bytes = folder_bytes + 32
};

const uint32_t host_patience = 5;

static const char card_option[] = "--card ";

static char folder[folder_bytes];

/// One operation; the emulator stands still until it is done.
static int32_t ask(uint32_t operation, const uint32_t* arguments)
{
    register uint32_t in_and_out __asm("r0") = operation;
    register const uint32_t* const block __asm("r1") = arguments;
    __asm volatile("bkpt 0xAB" : "+r"(in_and_out) : "r"(block) : "memory");
    return (int32_t)in_and_out;
}

static uint32_t address_of(const void* object)
{
    return (uint32_t)(uintptr_t)object;
}

static bool path_of(const char* name, const char* ending, char path[path_bytes])
{
    const size_t folder_length = strlen(folder);
    const size_t name_length = strlen(name);
    const size_t ending_length = strlen(ending);
    if (folder_length + 1U + name_length + ending_length + 1U > path_bytes)
    {
        return false;
    }
    memcpy(path, folder, folder_length);
    path[folder_length] = '/';
    memcpy(path + folder_length + 1U, name, name_length);
    memcpy(path + folder_length + 1U + name_length, ending, ending_length + 1U);
    return true;
}

/// Handle of the opened file, negative when it cannot be opened.
static int32_t open_file(const char* path, uint32_t mode)
{
    const uint32_t arguments[] = {address_of(path), mode, (uint32_t)strlen(path)};
    return ask(semihosting_open, arguments);
}

static bool close_file(int32_t file)
{
    const uint32_t arguments[] = {(uint32_t)file};
    return ask(semihosting_close, arguments) == 0;
}

static storage_status_t card_read(void* context, const char* name, uint8_t* data, size_t capacity, size_t* size)
{
    (void)context;
    *size = 0;
    char path[path_bytes];
    if (!path_of(name, "", path))
    {
        return storage_failed;
    }
    const int32_t file = open_file(path, semihosting_mode_read);
    if (file < 0)
    {
        return storage_missing;
    }
    const uint32_t handle[] = {(uint32_t)file};
    const int32_t length = ask(semihosting_length, handle);
    bool done = length >= 0 && (size_t)length <= capacity;
    if (done)
    {
        // the answer is how many bytes were not read
        const uint32_t arguments[] = {(uint32_t)file, address_of(data), (uint32_t)length};
        done = ask(semihosting_read, arguments) == 0;
        *size = (size_t)length;
    }
    return close_file(file) && done ? storage_ok : storage_failed;
}

/// A new file beside the old one takes its name when it is whole.
static storage_status_t card_replace(void* context, const char* name, const uint8_t* data, size_t size)
{
    (void)context;
    char path[path_bytes];
    char new_path[path_bytes];
    if (!path_of(name, "", path) || !path_of(name, ".new", new_path))
    {
        return storage_failed;
    }
    const int32_t file = open_file(new_path, semihosting_mode_write);
    if (file < 0)
    {
        return storage_failed;
    }
    const uint32_t writing[] = {(uint32_t)file, address_of(data), (uint32_t)size};
    const bool written = ask(semihosting_write, writing) == 0;
    const uint32_t renaming[] = {address_of(new_path), (uint32_t)strlen(new_path), address_of(path),
                                 (uint32_t)strlen(path)};
    return close_file(file) && written && ask(semihosting_rename, renaming) == 0 ? storage_ok : storage_failed;
}

/// The emulator's arguments, with a blank between them; empty without any.
static const char* command_line(void)
{
    static char line[line_bytes];
    uint32_t arguments[] = {address_of(line), line_bytes - 1U};
    if (ask(semihosting_command_line, arguments) != 0)
    {
        line[0] = '\0';
    }
    return line;
}

const storage_t* host_card(void)
{
    static const storage_t storage = {.context = NULL, .read = card_read, .replace = card_replace};
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
    return &storage;
}

/// Where the option stands in `line`, NULL where it does not; what is behind the card's is a part of its name.
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

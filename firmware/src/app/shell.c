#include "app/shell.h"

#include "app/shell_commands.h"
#include "app/shell_reply.h"

/// Split the line at its blanks. Returns the number of words, of which at most `maximum` are kept.
static size_t split(char* line, const char* words[], size_t maximum)
{
    size_t count = 0;
    char* at = line;
    while (*at != '\0')
    {
        while (*at == ' ' || *at == '\t')
        {
            *at = '\0';
            at++;
        }
        if (*at == '\0')
        {
            break;
        }
        if (count < maximum)
        {
            words[count] = at;
        }
        count++;
        while (*at != '\0' && *at != ' ' && *at != '\t')
        {
            at++;
        }
    }
    return count;
}

/// The number of words in `own` ("hil load gando") when `words` begins with them, else 0.
static size_t match(const char* own, const char* const words[], size_t count)
{
    size_t matched = 0;
    const char* at = own;
    while (*at != '\0')
    {
        char word[16];
        size_t length = 0;
        while (*at != '\0' && *at != ' ' && length + 1 < sizeof word)
        {
            word[length] = *at;
            length++;
            at++;
        }
        word[length] = '\0';
        at += *at == ' ' ? 1 : 0;
        if (matched >= count || !text_is(word, words[matched]))
        {
            return 0;
        }
        matched++;
    }
    return matched;
}

static void refuse(text_t* reply, const char* word)
{
    shell_begin(reply);
    text_add(reply, "unknown: ");
    text_add(reply, word);
    text_add(reply, " (try `help`)");
    shell_end(reply);
}

static void tell_usage(text_t* reply, const shell_command_t* command)
{
    shell_begin(reply);
    text_add(reply, "usage: ");
    text_add(reply, command->words);
    text_add(reply, command->arguments[0] == '\0' ? "" : " ");
    text_add(reply, command->arguments);
    shell_end(reply);
}

void shell_run(shell_t* shell, char* line, text_t* reply)
{
    enum
    {
        words_max = shell_words_max + 3
    };
    const char* words[words_max];
    const size_t count = split(line, words, words_max);
    if (count == 0)
    {
        return;
    }
    for (size_t i = shell_commands_count; i > 0; i--)
    {
        const shell_command_t* const command = &shell_commands[i - 1];
        const size_t own = match(command->words, words, count < words_max ? count : (size_t)words_max);
        if (own == 0)
        {
            continue;
        }
        shell_call_t call = {.shell = shell, .command = command, .reply = reply, .count = count - own};
        if (call.count > 0 && command->maximum == 0)
        {
            refuse(reply, words[own]);
            return;
        }
        if (call.count < command->minimum || call.count > command->maximum)
        {
            tell_usage(reply, command);
            return;
        }
        for (size_t word = 0; word < call.count; word++)
        {
            call.words[word] = words[own + word];
        }
        command->run(&call);
        return;
    }
    refuse(reply, words[0]);
}

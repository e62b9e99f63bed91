#include "app/shell_reply.h"

void shell_begin(text_t* reply)
{
    text_add(reply, "\r");
}

void shell_end(text_t* reply)
{
    text_add(reply, "\n");
}

void shell_line(text_t* reply, const char* words)
{
    shell_begin(reply);
    text_add(reply, words);
    shell_end(reply);
}

void shell_tell_result(text_t* reply, command_result_t result)
{
    static const char* const sentences[] = {
        [command_done] = "ok",
        [command_bad_value] = "refused: the value is outside of its range",
        [command_bad_state] = "refused: not possible in the present state (see `status`)",
        [command_unknown] = "refused: this board does not know that command",
        [command_storage_failed] = "failed: the card is missing or cannot be written",
    };
    shell_line(reply, sentences[result]);
}

void shell_tell_stored(text_t* reply, bool done)
{
    shell_tell_result(reply, done ? command_done : command_storage_failed);
}

void shell_tell_loaded(text_t* reply, bool done)
{
    shell_line(reply, done ? "ok" : "failed: the card is missing or holds no complete set; nothing was changed");
}

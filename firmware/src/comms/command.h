/// The interpreter of commands: a table from a command's type to its function, and the results of a command.
#ifndef COMMS_COMMAND_H
#define COMMS_COMMAND_H

#include <stddef.h>
#include <stdint.h>

/// Result of a command, with the numbers of the acknowledgement on the wire.
typedef enum
{
    command_done = 0,
    command_bad_value = 1,
    command_bad_state = 2,
    command_unknown = 3,
    command_storage_failed = 4
} command_result_t;

/// Do one command. `argument` is a constant of the table row, so that commands which differ by a number share a
/// function.
typedef command_result_t (*command_fn_t)(void* context, int32_t argument, const uint8_t* payload);

typedef struct
{
    uint32_t type_id;
    size_t payload_size; ///< bytes; a command of any other size is refused
    command_fn_t run;
    int32_t argument;
} command_t;

/// Run the row of `table` (ascending in `type_id`) for `type_id`: `command_unknown` when there is none,
/// `command_bad_value` when the size is not the row's.
command_result_t command_dispatch(const command_t* table, size_t count, void* context, uint32_t type_id,
                                  const uint8_t* payload, size_t payload_size);

#endif

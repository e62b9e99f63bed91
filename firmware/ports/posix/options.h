/// The command line of `epf-board`.
#ifndef OPTIONS_H
#define OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum
{
    options_line_pty,
    options_line_tcp,
    options_line_serial
} options_line_t;

typedef struct
{
    options_line_t line;
    const char* path;       ///< of the link or the device
    unsigned int port;      ///< 0: any free one
    const char* card;       ///< folder; NULL: no card
    bool legacy;            ///< no extensions
    uint32_t hil_period_ms; ///< 0: measured
    uint32_t seed;
    const char* hang_task; ///< this task hangs after a second; NULL: none
} options_t;

typedef enum
{
    options_run,
    options_shown, ///< help or version was asked for and printed
    options_wrong  ///< `error` says why
} options_result_t;

/// Read the command line.
options_result_t options_parse(options_t* options, int argc, char* argv[], char* error, size_t error_bytes);

#endif

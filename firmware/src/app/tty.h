/// What ttyTask does with received bytes: text mode, binary mode and the AHRS test, and the changes between them.
/// Independent of the kernel: bytes, board and time come in, text and frames go out.
#ifndef APP_TTY_H
#define APP_TTY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "app/shell.h"
#include "app/text.h"
#include "comms/frame.h"

typedef enum
{
    tty_text,      ///< lines to the shell; the board starts here
    tty_binary,    ///< frames, after `#QT\n`, until command 49
    tty_ahrs_test, ///< records of the attitude, after `#sim\r` and `#s00\0`, until `q`
} tty_mode_t;

enum
{
    tty_line_bytes = 96,
    tty_ahrs_period_ms = 20,
    tty_binary_period_ms = board_tick_period_ms,
    tty_silence_ms = 250 ///< a frame with a longer gap between its bytes is given up
};

typedef struct
{
    tty_mode_t mode;
    char line[tty_line_bytes];
    size_t line_size;
    bool line_is_noise; ///< it holds bytes that no keyboard sends
    bool line_is_long;
    bool ahrs_announced; ///< `#sim` was heard
    frame_decoder_t decoder;
    uint32_t heard_ms;
    uint32_t record_ms; ///< when the last AHRS record was due
    shell_t* shell;
    text_t reply; ///< text to be sent; the caller empties it
} tty_t;

/// Text mode, with an empty line. `reply` gets its room from the caller.
void tty_init(tty_t* tty, shell_t* shell, char* reply, size_t reply_bytes);

/// Take received bytes up to the end of a line, the end of binary mode or a request (`shell->request`) and return how
/// many were taken. Send `reply` and do what is requested before giving the rest.
size_t tty_receive(tty_t* tty, const uint8_t* bytes, size_t size, uint32_t now_ms);

/// Do what is due by the clock: time-outs, the board's own reports, an AHRS record into `reply`.
void tty_tick(tty_t* tty, uint32_t now_ms);

/// How long the caller may wait before the next `tty_tick`, in ms; UINT32_MAX: until bytes come in.
uint32_t tty_wait_ms(const tty_t* tty);

#endif

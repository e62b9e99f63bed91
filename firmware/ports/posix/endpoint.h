/// The end of the serial line on a PC: a pseudo-terminal, a TCP port or a serial device.
///
/// The line's thread (`line.c`) waits for a peer, moves bytes until the peer goes, and waits for the next one.
#ifndef ENDPOINT_H
#define ENDPOINT_H

#include <stdbool.h>
#include <stddef.h>

typedef struct endpoint endpoint_t;

struct endpoint
{
    /// The peer's descriptor (non-blocking), or -1 when none is there yet. Returns after half a second at most, and at
    /// once when `stop_fd` becomes readable.
    int (*wait_for_peer)(endpoint_t* endpoint, int stop_fd);

    /// The peer has gone: drop it, and the bytes that it did not read.
    void (*drop_peer)(endpoint_t* endpoint);

    /// Close everything when the board ends.
    void (*close)(endpoint_t* endpoint);

    char name[256];   ///< its address: pty:///path, tcp://127.0.0.1:port, serial:///dev/...
    const char* path; ///< link or device; must stay valid as long as the endpoint
    char target[128]; ///< what the link points to
    int fd;           ///< pseudo-terminal's master, listening socket or device; -1: not open
    int peer_fd;      ///< TCP's connection; -1: none
};

enum
{
    endpoint_error_bytes = 512
};

/// Make `path` a link to a new raw pseudo-terminal. False with a sentence in `error` when that fails.
bool endpoint_open_pty(endpoint_t* endpoint, const char* path, char error[endpoint_error_bytes]);

/// Listen on 127.0.0.1, on a free port when `port` is 0.
bool endpoint_open_tcp(endpoint_t* endpoint, unsigned int port, char error[endpoint_error_bytes]);

/// Open a serial device with 115200 8N1; it may be unplugged and plugged in again.
bool endpoint_open_serial(endpoint_t* endpoint, const char* path, char error[endpoint_error_bytes]);

/// Wait until `fd` (-1: nothing) or `stop_fd` is readable or `timeout_ms` is over. True when `fd` is.
bool endpoint_wait(int fd, int stop_fd, int timeout_ms);

#endif

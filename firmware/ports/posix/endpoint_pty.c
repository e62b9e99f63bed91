// Pseudo-terminals need functions that POSIX does not have.
#define _GNU_SOURCE

#include "endpoint.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

/// A pseudo-terminal that nobody has open reports "hung up" all the time, so look for a peer only at this interval.
static const int peer_poll_ms = 10;

bool endpoint_wait(int fd, int stop_fd, int timeout_ms)
{
    struct pollfd waits[] = {{.fd = stop_fd, .events = POLLIN}, {.fd = fd, .events = POLLIN}};
    return poll(waits, 2, timeout_ms) > 0 && waits[1].revents != 0;
}

static bool has_peer(const endpoint_t* endpoint)
{
    struct pollfd state = {.fd = endpoint->fd, .events = POLLIN};
    (void)poll(&state, 1, 0);
    // Bytes that a peer wrote before it closed are still read.
    return (state.revents & POLLHUP) == 0 || (state.revents & POLLIN) != 0;
}

static int wait_for_peer(endpoint_t* endpoint, int stop_fd)
{
    for (int waited_ms = 0; waited_ms < 500; waited_ms += peer_poll_ms)
    {
        if (has_peer(endpoint))
        {
            return endpoint->fd;
        }
        struct pollfd stop = {.fd = stop_fd, .events = POLLIN};
        if (poll(&stop, 1, peer_poll_ms) > 0)
        {
            break;
        }
    }
    return -1;
}

/// Throw away what the last peer did not read, so that the next one only gets new bytes.
static void drop_peer(endpoint_t* endpoint)
{
    const int terminal = open(endpoint->target, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (terminal >= 0)
    {
        // First the output, which would otherwise arrive after the input was flushed, then the input.
        (void)tcflush(endpoint->fd, TCOFLUSH);
        (void)tcflush(terminal, TCIFLUSH);
        (void)close(terminal);
    }
}

static void close_pty(endpoint_t* endpoint)
{
    char points_to[sizeof endpoint->target];
    const ssize_t length = readlink(endpoint->path, points_to, sizeof points_to - 1);
    // Another board may have put its own link there meanwhile.
    if (length >= 0 && (size_t)length == strlen(endpoint->target) &&
        memcmp(points_to, endpoint->target, (size_t)length) == 0)
    {
        (void)unlink(endpoint->path);
    }
}

/// Raw mode, so that no byte is changed or echoed. The settings last while the master is open, even without a peer.
static bool make_raw(const char* terminal_name)
{
    const int terminal = open(terminal_name, O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (terminal < 0)
    {
        return false;
    }
    struct termios settings;
    bool done = tcgetattr(terminal, &settings) == 0;
    cfmakeraw(&settings);
    (void)cfsetspeed(&settings, B115200);
    done = done && tcsetattr(terminal, TCSANOW, &settings) == 0;
    (void)close(terminal);
    return done;
}

/// Create the link in one step. It may replace a link that an earlier board left behind, but never a real file.
static bool place_link(const endpoint_t* endpoint, char error[endpoint_error_bytes])
{
    struct stat there;
    if (lstat(endpoint->path, &there) == 0 && !S_ISLNK(there.st_mode))
    {
        (void)snprintf(error, endpoint_error_bytes,
                       "--pty %s: there is a file of that name and it is no link; choose another name or remove it.",
                       endpoint->path);
        return false;
    }
    char new_link[4096];
    const int length = snprintf(new_link, sizeof new_link, "%s.%ld.new", endpoint->path, (long)getpid());
    if (length < 0 || (size_t)length >= sizeof new_link || symlink(endpoint->target, new_link) != 0)
    {
        (void)snprintf(error, endpoint_error_bytes,
                       "--pty %s: the link cannot be made: %s. Choose a folder that exists and is writable.",
                       endpoint->path, strerror(errno));
        return false;
    }
    if (rename(new_link, endpoint->path) != 0)
    {
        (void)snprintf(error, endpoint_error_bytes, "--pty %s: the link cannot be put in place: %s.", endpoint->path,
                       strerror(errno));
        (void)unlink(new_link);
        return false;
    }
    return true;
}

bool endpoint_open_pty(endpoint_t* endpoint, const char* path, char error[endpoint_error_bytes])
{
    memset(endpoint, 0, sizeof *endpoint);
    *endpoint = (endpoint_t){.wait_for_peer = wait_for_peer,
                             .drop_peer = drop_peer,
                             .close = close_pty,
                             .path = path,
                             .fd = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC),
                             .peer_fd = -1};
    if (endpoint->fd < 0 || grantpt(endpoint->fd) != 0 || unlockpt(endpoint->fd) != 0 ||
        ptsname_r(endpoint->fd, endpoint->target, sizeof endpoint->target) != 0 || !make_raw(endpoint->target))
    {
        (void)snprintf(error, endpoint_error_bytes, "--pty %s: no pseudo-terminal can be opened: %s.", path,
                       strerror(errno));
        return false;
    }
    (void)snprintf(endpoint->name, sizeof endpoint->name, "pty://%s", path);
    return place_link(endpoint, error);
}

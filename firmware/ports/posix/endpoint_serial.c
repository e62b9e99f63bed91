#define _DEFAULT_SOURCE // cfmakeraw

#include "endpoint.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

/// 115200 8N1, without flow control and modem lines.
static bool open_device(endpoint_t* endpoint)
{
    const int device = open(endpoint->path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (device < 0)
    {
        return false;
    }
    struct termios settings;
    if (tcgetattr(device, &settings) != 0)
    {
        (void)close(device);
        return false;
    }
    cfmakeraw(&settings);
    (void)cfsetspeed(&settings, B115200);
    settings.c_cflag &= ~(tcflag_t)(CSTOPB | PARENB | CRTSCTS);
    settings.c_cflag |= CLOCAL | CREAD | CS8;
    if (tcsetattr(device, TCSANOW, &settings) != 0)
    {
        (void)close(device);
        return false;
    }
    endpoint->fd = device;
    return true;
}

static int wait_for_peer(endpoint_t* endpoint, int stop_fd)
{
    if (endpoint->fd < 0 && !open_device(endpoint))
    {
        (void)endpoint_wait(-1, stop_fd, 500); // unplugged: try again twice a second
    }
    return endpoint->fd;
}

static void drop_peer(endpoint_t* endpoint)
{
    (void)close(endpoint->fd);
    endpoint->fd = -1;
}

static void close_serial(endpoint_t* endpoint)
{
    if (endpoint->fd >= 0)
    {
        (void)close(endpoint->fd);
    }
}

bool endpoint_open_serial(endpoint_t* endpoint, const char* path, char error[endpoint_error_bytes])
{
    memset(endpoint, 0, sizeof *endpoint);
    *endpoint = (endpoint_t){.wait_for_peer = wait_for_peer,
                             .drop_peer = drop_peer,
                             .close = close_serial,
                             .path = path,
                             .fd = -1,
                             .peer_fd = -1};
    if (!open_device(endpoint))
    {
        (void)snprintf(error, endpoint_error_bytes,
                       "--serial %s: the device cannot be opened as a serial line: %s. Check its name, its cable and "
                       "your rights to it.",
                       path, strerror(errno));
        return false;
    }
    (void)snprintf(endpoint->name, sizeof endpoint->name, "serial://%s", path);
    return true;
}

#define _GNU_SOURCE // accept4

#include "endpoint.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

static int wait_for_peer(endpoint_t* endpoint, int stop_fd)
{
    if (!endpoint_wait(endpoint->fd, stop_fd, 500))
    {
        return -1;
    }
    endpoint->peer_fd = accept4(endpoint->fd, NULL, NULL, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (endpoint->peer_fd >= 0)
    {
        const int yes = 1;
        (void)setsockopt(endpoint->peer_fd, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    }
    return endpoint->peer_fd;
}

static void drop_peer(endpoint_t* endpoint)
{
    (void)close(endpoint->peer_fd);
    endpoint->peer_fd = -1;
}

static void close_tcp(endpoint_t* endpoint)
{
    (void)close(endpoint->fd);
}

bool endpoint_open_tcp(endpoint_t* endpoint, unsigned int port, char error[endpoint_error_bytes])
{
    memset(endpoint, 0, sizeof *endpoint);
    *endpoint = (endpoint_t){.wait_for_peer = wait_for_peer,
                             .drop_peer = drop_peer,
                             .close = close_tcp,
                             .fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0),
                             .peer_fd = -1};
    struct sockaddr_in address;
    memset(&address, 0, sizeof address);
    address.sin_family = AF_INET;
    address.sin_port = htons((uint16_t)port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t address_size = sizeof address;
    const int yes = 1;
    // Small buffers, like a serial line's, so that a station that reads after a pause gets recent bytes. Connections
    // inherit the sizes.
    const int held_bytes = 16384;
    if (endpoint->fd < 0 || setsockopt(endpoint->fd, SOL_SOCKET, SO_SNDBUF, &held_bytes, sizeof held_bytes) != 0 ||
        setsockopt(endpoint->fd, SOL_SOCKET, SO_RCVBUF, &held_bytes, sizeof held_bytes) != 0 ||
        setsockopt(endpoint->fd, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) != 0 ||
        bind(endpoint->fd, (const struct sockaddr*)&address, sizeof address) != 0 || listen(endpoint->fd, 4) != 0 ||
        getsockname(endpoint->fd, (struct sockaddr*)&address, &address_size) != 0)
    {
        (void)snprintf(error, endpoint_error_bytes, "--tcp %u: the port cannot be opened: %s. Choose another one.",
                       port, strerror(errno));
        return false;
    }
    (void)snprintf(endpoint->name, sizeof endpoint->name, "tcp://127.0.0.1:%u", (unsigned int)ntohs(address.sin_port));
    return true;
}

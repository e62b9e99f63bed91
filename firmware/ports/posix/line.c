#define _GNU_SOURCE // dup3

#include "line.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdint.h>
#include <unistd.h>

#include "common/byte_ring.h"
#include "kernel.h"

enum
{
    receive_bytes = 4096 ///< 350 ms of a 115200 line
};

static struct
{
    endpoint_t* endpoint;
    int stop_fd;
    void (*stopped)(void);
    /// The descriptor that tasks write to: the peer, or the null device while there is none. Its number never changes,
    /// so a task that writes while the peer goes cannot write to another file; its bytes are lost, as on a cut wire.
    int wire_fd;
    int null_fd;
    uint8_t received[receive_bytes];
    byte_ring_t ring;
    uart_interrupt_t interrupt;
    void* interrupt_context;
} line;

static bool is_stopped(void)
{
    struct pollfd stop = {.fd = line.stop_fd, .events = POLLIN};
    return poll(&stop, 1, 0) > 0;
}

/// Move received bytes into the ring. False when the peer has gone.
static bool receive(int peer_fd)
{
    uint8_t bytes[receive_bytes];
    size_t room = byte_ring_room(&line.ring);
    if (room == 0U)
    {
        // The ring is full: the PC holds the bytes until the board has caught up.
        (void)endpoint_wait(-1, line.stop_fd, 1);
        return true;
    }
    if (!endpoint_wait(peer_fd, line.stop_fd, 500))
    {
        return true;
    }
    const ssize_t count = read(peer_fd, bytes, room);
    if (count > 0)
    {
        (void)byte_ring_put(&line.ring, bytes, (size_t)count);
        kernel_raise(kernel_interrupt_uart);
        return true;
    }
    return count < 0 && (errno == EAGAIN || errno == EINTR);
}

static void* run(void* unused)
{
    (void)unused;
    while (!is_stopped())
    {
        const int peer_fd = line.endpoint->wait_for_peer(line.endpoint, line.stop_fd);
        if (peer_fd < 0)
        {
            continue;
        }
        (void)dup3(peer_fd, line.wire_fd, O_CLOEXEC);
        while (!is_stopped() && receive(peer_fd))
        {
        }
        (void)dup3(line.null_fd, line.wire_fd, O_CLOEXEC);
        line.endpoint->drop_peer(line.endpoint);
    }
    line.endpoint->close(line.endpoint);
    line.stopped();
    return NULL;
}

bool line_start(endpoint_t* endpoint, int stop_fd, void (*stopped)(void))
{
    line.endpoint = endpoint;
    line.stop_fd = stop_fd;
    line.stopped = stopped;
    line.null_fd = open("/dev/null", O_WRONLY | O_CLOEXEC);
    line.wire_fd = open("/dev/null", O_WRONLY | O_CLOEXEC);
    byte_ring_init(&line.ring, line.received, sizeof line.received);
    pthread_t thread;
    return line.null_fd >= 0 && line.wire_fd >= 0 && pthread_create(&thread, NULL, run, NULL) == 0;
}

static size_t uart_read(void* context, uint8_t* bytes, size_t capacity)
{
    (void)context;
    return byte_ring_take(&line.ring, bytes, capacity);
}

static size_t uart_write(void* context, const uint8_t* bytes, size_t size)
{
    (void)context;
    const ssize_t count = write(line.wire_fd, bytes, size);
    if (count >= 0)
    {
        return (size_t)count;
    }
    // Full: try later. Any other error means that the peer has just gone; its bytes are lost.
    return errno == EAGAIN || errno == EINTR ? 0U : size;
}

static bool on_interrupt(void)
{
    return line.interrupt(line.interrupt_context);
}

static void uart_on_receive(void* context, uart_interrupt_t interrupt, void* interrupt_context)
{
    (void)context;
    line.interrupt = interrupt;
    line.interrupt_context = interrupt_context;
    kernel_serve(kernel_interrupt_uart, on_interrupt);
}

uart_t line_uart(void)
{
    return (uart_t){.context = NULL, .read = uart_read, .write = uart_write, .on_receive = uart_on_receive};
}

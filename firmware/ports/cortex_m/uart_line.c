#include "uart_line.h"

#include "FreeRTOS.h"
#include "task.h"

#include "common/byte_ring.h"
#include "machine.h"

enum
{
    ring_bytes = 512 ///< 44 ms of a 115200 line
};

static struct
{
    byte_ring_t received; ///< interrupt to task
    byte_ring_t sending;  ///< task to interrupt
    uint8_t received_bytes[ring_bytes];
    uint8_t sending_bytes[ring_bytes];
    uart_interrupt_t interrupt;
    void* interrupt_context;
} line;

/// Fetch what has come in. A ring without room leaves the rest where it is and the interrupt off until it is read.
/// True when bytes came into an empty ring: its reader sleeps, or will look once more before it does.
static bool fetch(void)
{
    const bool was_empty = byte_ring_room(&line.received) == ring_bytes;
    bool has_fetched = false;
    uint8_t byte = 0;
    while (byte_ring_room(&line.received) > 0U && machine_uart_receive(&byte))
    {
        (void)byte_ring_put(&line.received, &byte, 1U);
        has_fetched = true;
    }
    machine_uart_watch_receiver(byte_ring_room(&line.received) > 0U);
    return was_empty && has_fetched;
}

static void transmit(void)
{
    const uint8_t* bytes = NULL;
    size_t size = byte_ring_peek(&line.sending, &bytes);
    while (size > 0U && machine_uart_transmit(bytes[0]))
    {
        byte_ring_skip(&line.sending, 1U);
        size = byte_ring_peek(&line.sending, &bytes);
    }
    if (size == 0U)
    {
        machine_uart_watch_transmitter(false);
    }
}

void uart_line_interrupt(void)
{
    const bool has_news = fetch();
    transmit();
    if (has_news && line.interrupt != NULL)
    {
        portYIELD_FROM_ISR(line.interrupt(line.interrupt_context) ? pdTRUE : pdFALSE);
    }
}

static size_t uart_read(void* context, uint8_t* bytes, size_t capacity)
{
    (void)context;
    const bool was_full = byte_ring_room(&line.received) == 0U;
    const size_t count = byte_ring_take(&line.received, bytes, capacity);
    if (was_full)
    {
        taskENTER_CRITICAL();
        machine_uart_watch_receiver(true);
        taskEXIT_CRITICAL();
    }
    return count;
}

static size_t uart_write(void* context, const uint8_t* bytes, size_t size)
{
    (void)context;
    const size_t count = byte_ring_put(&line.sending, bytes, size);
    if (count > 0U)
    {
        taskENTER_CRITICAL();
        machine_uart_watch_transmitter(true);
        taskEXIT_CRITICAL();
    }
    return count;
}

static void uart_on_receive(void* context, uart_interrupt_t interrupt, void* interrupt_context)
{
    (void)context;
    line.interrupt = interrupt;
    line.interrupt_context = interrupt_context;
    machine_uart_enable();
}

uart_t uart_line(void)
{
    byte_ring_init(&line.received, line.received_bytes, sizeof line.received_bytes);
    byte_ring_init(&line.sending, line.sending_bytes, sizeof line.sending_bytes);
    return (uart_t){.context = NULL, .read = uart_read, .write = uart_write, .on_receive = uart_on_receive};
}

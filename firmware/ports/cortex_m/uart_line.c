#include "uart_line.h"

#include "FreeRTOS.h"
#include "task.h"

#include "common/byte_ring.h"
#include "machine.h"

// The kernel names this function; nothing else may call it, so it has no header.
void vApplicationTickHook(void);

enum
{
    ring_bytes = 512, ///< 44 ms of a 115200 line
    wake_bytes = 8    ///< the deployed board's own threshold
};

static struct
{
    byte_ring_t received; ///< from interrupt to task
    byte_ring_t sending;  ///< from task to interrupt
    bool is_held_back;    ///< the receive interrupt is off because there is no room
    bool is_sending;      ///< the transmitter's interrupt is on
    uint8_t received_bytes[ring_bytes];
    uint8_t sending_bytes[ring_bytes];
    uart_interrupt_t interrupt;
    void* interrupt_context;
} line;

static size_t held(void)
{
    return ring_bytes - byte_ring_room(&line.received);
}

/// Fetch received bytes. When the ring is full, the rest stays in the receiver and its interrupt off until the ring is
/// read. True when the reader should run: not for each byte, which would cost more than all other work of the line, but
/// for several, or for a line feed, which ends every frame and line. The next tick finds what ends otherwise.
static bool fetch(void)
{
    bool is_end = false;
    bool has_fetched = false;
    uint8_t byte = 0;
    while (byte_ring_room(&line.received) > 0U && machine_uart_receive(&byte))
    {
        (void)byte_ring_put(&line.received, &byte, 1U);
        has_fetched = true;
        is_end = is_end || byte == (uint8_t)'\n';
    }
    if (byte_ring_room(&line.received) == 0U)
    {
        line.is_held_back = true;
        machine_uart_watch_receiver(false);
    }
    return has_fetched && (is_end || held() >= wake_bytes);
}

/// Wake the reader, from an interrupt.
static bool wake(void)
{
    return line.interrupt != NULL && line.interrupt(line.interrupt_context);
}

static void transmit(void)
{
    if (!line.is_sending)
    {
        return;
    }
    const uint8_t* bytes = NULL;
    size_t size = byte_ring_peek(&line.sending, &bytes);
    while (size > 0U && machine_uart_transmit(bytes[0]))
    {
        byte_ring_skip(&line.sending, 1U);
        size = byte_ring_peek(&line.sending, &bytes);
    }
    if (size == 0U)
    {
        line.is_sending = false;
        machine_uart_watch_transmitter(false);
    }
}

void uart_line_interrupt(void)
{
    const bool has_news = fetch();
    transmit();
    portYIELD_FROM_ISR(has_news && wake() ? pdTRUE : pdFALSE);
}

/// The kernel switches to woken tasks by itself after this hook.
void vApplicationTickHook(void)
{
    if (held() > 0U)
    {
        (void)wake();
    }
}

static size_t uart_read(void* context, uint8_t* bytes, size_t capacity)
{
    (void)context;
    const size_t count = byte_ring_take(&line.received, bytes, capacity);
    if (line.is_held_back)
    {
        taskENTER_CRITICAL();
        line.is_held_back = false;
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
        line.is_sending = true;
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

// Arm's MPS2 board with image AN386 (application note AN386): a second Cortex-M4F with another serial port (CMSDK
// APB UART), which shows where the application relies on properties of the first.
#include "machine.h"

#include "core.h"
#include "startup.h"
#include "uart_line.h"

#define REGISTER(address) (*(volatile uint32_t*)(address))

#define UART0_DATA REGISTER(0x40004000U)
#define UART0_STATE REGISTER(0x40004004U)
#define UART0_STATE_TRANSMITTER_FULL 1U
#define UART0_STATE_RECEIVER_FULL 2U
#define UART0_CONTROL REGISTER(0x40004008U)
#define UART0_CONTROL_TRANSMIT 1U
#define UART0_CONTROL_RECEIVE 2U
#define UART0_CONTROL_TRANSMIT_INTERRUPT 4U
#define UART0_CONTROL_RECEIVE_INTERRUPT 8U
#define UART0_INTERRUPTS REGISTER(0x4000400CU) ///< interrupts that are raised; writing a 1 clears one
#define UART0_INTERRUPTS_BOTH 3U
#define UART0_BAUD_DIVIDER REGISTER(0x40004010U)

enum
{
    receive_interrupt = 0,
    transmit_interrupt = 1,
    vector_count = 32
};

static const uint32_t board_hz = 25000000U;
static const uint32_t baud = 115200U;

uint32_t machine_clock_hz;

static void serve_uart(void)
{
    UART0_INTERRUPTS = UART0_INTERRUPTS_BOTH;
    uart_line_interrupt();
}

/// An unused interrupt was never enabled, so its arrival is a fault.
#define UNUSED {.handler = startup_fault}
#define UNUSED_5 UNUSED, UNUSED, UNUSED, UNUSED, UNUSED
#define UNUSED_15 UNUSED_5, UNUSED_5, UNUSED_5

__attribute__((section(".vectors.machine"), used)) static const startup_vector_t vectors[vector_count] = {
    {.handler = serve_uart},
    {.handler = serve_uart},
    UNUSED_15,
    UNUSED_15,
};

void machine_start(void)
{
    machine_clock_hz = board_hz;
    UART0_BAUD_DIVIDER = board_hz / baud;
    UART0_CONTROL = UART0_CONTROL_TRANSMIT | UART0_CONTROL_RECEIVE | UART0_CONTROL_RECEIVE_INTERRUPT;
}

void machine_uart_enable(void)
{
    core_interrupt_enable(receive_interrupt);
    core_interrupt_enable(transmit_interrupt);
}

bool machine_uart_receive(uint8_t* byte)
{
    if ((UART0_STATE & UART0_STATE_RECEIVER_FULL) == 0U)
    {
        return false;
    }
    *byte = (uint8_t)UART0_DATA;
    return true;
}

void machine_uart_watch_receiver(bool on)
{
    const bool is_on = (UART0_CONTROL & UART0_CONTROL_RECEIVE_INTERRUPT) != 0U;
    UART0_CONTROL =
        on ? UART0_CONTROL | UART0_CONTROL_RECEIVE_INTERRUPT : UART0_CONTROL & ~UART0_CONTROL_RECEIVE_INTERRUPT;
    if (on && !is_on)
    {
        // A byte that arrived while it was off did not raise it.
        core_interrupt_pend(receive_interrupt);
    }
}

bool machine_uart_transmit(uint8_t byte)
{
    if ((UART0_STATE & UART0_STATE_TRANSMITTER_FULL) != 0U)
    {
        return false;
    }
    UART0_DATA = byte;
    return true;
}

void machine_uart_watch_transmitter(bool on)
{
    if (on)
    {
        UART0_CONTROL |= UART0_CONTROL_TRANSMIT_INTERRUPT;
        core_interrupt_pend(transmit_interrupt);
    }
    else
    {
        UART0_CONTROL &= ~UART0_CONTROL_TRANSMIT_INTERRUPT;
    }
}

void machine_watchdog_start(void)
{
    // No watchdog: only the application's supervisor restarts this board.
}

void machine_watchdog_feed(void)
{
    // No watchdog to feed.
}

const spi_t* machine_card_bus(void)
{
    return NULL;
}

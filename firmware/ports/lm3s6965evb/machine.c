// TI's LM3S6965 evaluation board as QEMU emulates it, with a Cortex-M4F in place of its Cortex-M3. It is the only one
// of QEMU's boards for such a processor with a memory card on a bus: its images test the card's driver, and show where
// the application relies on properties of the STM32F405.
#include "machine.h"

#include "core.h"
#include "registers.h"
#include "startup.h"
#include "uart_line.h"

enum
{
    vector_count = 44
};

static const uint32_t reset_hz = 12500000U; ///< at reset; fast enough here
static const uint32_t baud = 115200U;

uint32_t machine_clock_hz;

static void serve_uart(void)
{
    UART0_ICR = UART0_IM_TRANSMIT;
    uart_line_interrupt();
}

/// An unused interrupt was never enabled, so its arrival is a fault.
#define UNUSED {.handler = startup_fault}
#define UNUSED_5 UNUSED, UNUSED, UNUSED, UNUSED, UNUSED
#define UNUSED_19 UNUSED_5, UNUSED_5, UNUSED_5, UNUSED, UNUSED, UNUSED, UNUSED

__attribute__((section(".vectors.machine"), used)) static const startup_vector_t vectors[vector_count] = {
    UNUSED_5,
    {.handler = serve_uart},
    UNUSED_19,
    UNUSED_19,
};

void machine_start(void)
{
    machine_clock_hz = reset_hz;
    SYSCTL_RCGC1 |= SYSCTL_RCGC1_UART0 | SYSCTL_RCGC1_SSI0;
    SYSCTL_RCGC2 |= SYSCTL_RCGC2_GPIOD;
    core_barrier();
    // divider of the clock / 16, in 64ths
    const uint32_t divider = (reset_hz * 4U + baud / 2U) / baud;
    UART0_IBRD = divider / 64U;
    UART0_FBRD = divider % 64U;
    UART0_LCRH = UART0_LCRH_8_BITS;
    UART0_IM = UART0_IM_RECEIVE;
    UART0_CTL = UART0_CTL_ON;
}

void machine_uart_enable(void)
{
    core_interrupt_enable(UART0_INTERRUPT);
}

bool machine_uart_receive(uint8_t* byte)
{
    if ((UART0_FR & UART0_FR_RECEIVER_EMPTY) != 0U)
    {
        return false;
    }
    *byte = (uint8_t)UART0_DR;
    return true;
}

void machine_uart_watch_receiver(bool on)
{
    UART0_IM = on ? UART0_IM | UART0_IM_RECEIVE : UART0_IM & ~UART0_IM_RECEIVE;
}

bool machine_uart_transmit(uint8_t byte)
{
    if ((UART0_FR & UART0_FR_TRANSMITTER_FULL) != 0U)
    {
        return false;
    }
    UART0_DR = byte;
    return true;
}

void machine_uart_watch_transmitter(bool on)
{
    if (on)
    {
        UART0_IM |= UART0_IM_TRANSMIT;
        core_interrupt_pend(UART0_INTERRUPT);
    }
    else
    {
        UART0_IM &= ~UART0_IM_TRANSMIT;
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

/// What one processor has to offer besides its core: a clock, one serial line, a watchdog and a slot for a card.
/// Implemented by each of ports/stm32f405, ports/mps2_an386 and ports/lm3s6965evb.
#ifndef MACHINE_H
#define MACHINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/spi.h"

/// Of the core and its tick timer; valid after `machine_start`.
extern uint32_t machine_clock_hz;

/// Bring clock and serial line up (115200 8N1), the line's interrupts still masked in the core.
void machine_start(void);

/// The line's interrupts reach the core from now on.
void machine_uart_enable(void);

/// Take one received byte; false when there is none.
bool machine_uart_receive(uint8_t* byte);

/// Whether reception raises the interrupt. Off while there is no room for more.
void machine_uart_watch_receiver(bool on);

/// Give one byte to the transmitter; false when that still has one.
bool machine_uart_transmit(uint8_t byte);

/// Whether a transmitter that is ready raises the interrupt, and have it raised once now when `on`: not every model of
/// this processor raises it by itself.
void machine_uart_watch_transmitter(bool on);

/// Have the watchdog restart the processor unless it is fed at least once a second from now on. Nothing where the
/// machine has none.
void machine_watchdog_start(void);
void machine_watchdog_feed(void);

/// The bus to the slot of a memory card, ready for use; NULL where the machine has none. Valid after `machine_start`.
const spi_t* machine_card_bus(void);

#endif

/// The devices of one processor besides its core: clock, one serial line, watchdog and a slot for a card.
/// Implemented by each of ports/stm32f405 and ports/lm3s6965evb.
#ifndef MACHINE_H
#define MACHINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "hal/spi.h"

/// Frequency of the core and its tick timer; valid after `machine_start`.
extern uint32_t machine_clock_hz;

/// Start clock and serial line (115200 8N1); the core still masks the line's interrupts.
void machine_start(void);

/// From now on, let the line's interrupts reach the core.
void machine_uart_enable(void);

/// Take one received byte; false when there is none.
bool machine_uart_receive(uint8_t* byte);

/// Switch the receive interrupt. It is off while there is no room for more bytes.
void machine_uart_watch_receiver(bool on);

/// Give one byte to the transmitter; false when it still holds the previous one.
bool machine_uart_transmit(uint8_t byte);

/// Switch the interrupt of a ready transmitter. When `on`, raise it once by software too, because not every emulator
/// raises it.
void machine_uart_watch_transmitter(bool on);

/// Start the watchdog: from now on it restarts the processor unless it is fed at least once a second. Does nothing
/// where the machine has none.
void machine_watchdog_start(void);
void machine_watchdog_feed(void);

/// The bus to the slot of a memory card, ready for use; NULL where the machine has none. Valid after `machine_start`.
const spi_t* machine_card_bus(void);

#endif

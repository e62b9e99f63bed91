/// The serial line to the ground station, driven by interrupts in both directions.
#ifndef UART_LINE_H
#define UART_LINE_H

#include "hal/uart.h"

/// The line; it exists as long as the program. Its interrupts start with the call of `on_receive`.
uart_t uart_line(void);

/// Serve the line's interrupt, whatever raised it.
void uart_line_interrupt(void);

#endif

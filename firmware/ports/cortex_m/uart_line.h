/// The serial line to the ground station, driven by interrupts both ways.
#ifndef UART_LINE_H
#define UART_LINE_H

#include "hal/uart.h"

/// The line; it lives as long as the program. Interrupts come once `on_receive` was called.
uart_t uart_line(void);

/// Serve the line's interrupt, whatever raised it.
void uart_line_interrupt(void);

#endif

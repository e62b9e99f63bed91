/// The serial line's device: a thread that acts as the receiver, and the interrupt that it raises.
#ifndef LINE_H
#define LINE_H

#include "endpoint.h"
#include "hal/uart.h"

/// Start the line's thread over an open endpoint. It runs until `stop_fd` becomes readable, closes the endpoint and
/// calls `stopped`. False when the thread cannot be started.
bool line_start(endpoint_t* endpoint, int stop_fd, void (*stopped)(void));

/// The line as the application sees it.
uart_t line_uart(void);

#endif

/// The tasks between the serial line and the board: receive, transmit, interpret, and store for the station.
#ifndef APP_TASK_LINE_H
#define APP_TASK_LINE_H

void run_uart_rx(void* context);
void run_uart_tx(void* context);
void run_tty(void* context);
void run_card(void* context);

#endif

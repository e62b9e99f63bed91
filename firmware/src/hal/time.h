/// The board's clock. Implemented by each port.
#ifndef HAL_TIME_H
#define HAL_TIME_H

#include <stdint.h>

/// Milliseconds since the board was powered; wraps after 49 days, so only differences mean anything.
uint32_t time_ms(void);

#endif

/// Clocks of the STM32F405's buses, for its devices.
#ifndef MACHINE_CLOCK_H
#define MACHINE_CLOCK_H

#include <stdint.h>

extern uint32_t machine_fast_bus_hz; ///< APB2; valid after `machine_start`
extern uint32_t machine_slow_bus_hz; ///< APB1; valid after `machine_start`

#endif

/// The devices and options that a port gives to the application.
#ifndef APP_APPLICATION_HARDWARE_H
#define APP_APPLICATION_HARDWARE_H

#include <stdbool.h>
#include <stdint.h>

#include "hal/sensors.h"
#include "hal/servos.h"
#include "hal/storage.h"
#include "hal/uart.h"
#include "hal/watchdog.h"

typedef struct
{
    uart_t uart;
    sensors_t sensors;
    servos_t servos;
    const storage_t* storage; ///< NULL: there is no card
    watchdog_t watchdog;
    const char* restart_reason; ///< why the board restarted itself; NULL: power-on, or a person restarted it
    const char* hang_task;      ///< to test the watchdog: this task hangs after a second; NULL: none
    bool measures_stacks;       ///< whether the tasks run on the kernel's stacks, so that these can be measured
    bool legacy;                ///< like a deployed board: no extension exists
    uint32_t hil_period_ms;     ///< time of one HIL step; 0: measured
} application_hardware_t;

#endif

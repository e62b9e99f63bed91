/// The board's application: the same on every target. A port gives it its devices and starts it.
#ifndef APP_APPLICATION_H
#define APP_APPLICATION_H

#include "app/application_hardware.h"

/// Start the board's tasks; never returns.
_Noreturn void application_run(const application_hardware_t* hardware);

#endif

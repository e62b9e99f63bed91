/// The start of the board: at power-on, and when the station or a person resets it.
#ifndef APP_APPLICATION_RESET_H
#define APP_APPLICATION_RESET_H

#include "app/application_state.h"

/// Start again as after power-on: defaults, the card's parameters and plans, text mode. Without the plans where the
/// board `may_be_in_flight`.
void application_reset(application_t* app, bool may_be_in_flight);

#endif

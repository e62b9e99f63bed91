/// The board's start, at power-on and by the station's or a person's reset.
#ifndef APP_APPLICATION_RESET_H
#define APP_APPLICATION_RESET_H

#include "app/application_state.h"

/// Begin anew, as after power-on: defaults, the card's parameters and plans, text mode. Without the plans where the
/// board `may_be_in_flight`.
void application_reset(application_t* app, bool may_be_in_flight);

#endif

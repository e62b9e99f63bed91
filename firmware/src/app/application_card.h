/// The card and the tasks: whoever uses it waits for it, and nobody else does.
#ifndef APP_APPLICATION_CARD_H
#define APP_APPLICATION_CARD_H

#include <stdbool.h>

#include "app/application_state.h"

/// Have the card for oneself, before the board is locked, and give it back. The calling task may wait for long.
void application_take_card(application_t* app);
void application_give_card(application_t* app);

/// Put one thing on the card, or take the parameters from there. The calling task waits for the card; the board goes
/// on. True when it is done.
bool application_store(application_t* app, board_keeps_t what);
bool application_load(application_t* app);

/// Put every plan on the card that was uploaded and is not there yet.
void application_store_plans(application_t* app);

#endif

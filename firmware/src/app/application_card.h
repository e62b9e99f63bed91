/// Storing and loading. The task that uses the card waits for it; the board and the other tasks do not.
#ifndef APP_APPLICATION_CARD_H
#define APP_APPLICATION_CARD_H

#include <stdbool.h>

#include "app/application_state.h"

/// Lock the card and unlock it. Lock it before the board, never after; the calling task may wait for long.
void application_take_card(application_t* app);
void application_give_card(application_t* app);

/// Store parameters and own gains on the card, or load them from it. The calling task waits for the card. True on
/// success.
bool application_store_tuning(application_t* app);
bool application_load(application_t* app);

/// Store every uploaded plan that is not on the card yet.
void application_store_plans(application_t* app);

#endif

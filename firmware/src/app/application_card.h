/// Storing and loading. The task that uses the card waits for it; the board and the other tasks do not.
#ifndef APP_APPLICATION_CARD_H
#define APP_APPLICATION_CARD_H

#include <stdbool.h>

#include "app/application_state.h"

/// Lock the card and unlock it. Lock it before the board, never after; the calling task may wait for long.
void application_take_card(application_t* app);
void application_give_card(application_t* app);

/// Store one thing on the card, or load the parameters from it. The calling task waits for the card. True on success.
bool application_store(application_t* app, board_keeps_t what);
bool application_load(application_t* app);

/// Store every uploaded plan that is not on the card yet.
void application_store_plans(application_t* app);

#endif

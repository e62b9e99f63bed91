/// What the board keeps on its card: parameters and uploaded plans, each complete or not at all.
///
/// A store has three steps, so that a task that only needs the board never waits for the card: take, write, note. From
/// the first to the last of them the card and `room` belong to the caller; only `board_card_write` takes long.
#ifndef FLIGHT_BOARD_CARD_H
#define FLIGHT_BOARD_CARD_H

#include <stdbool.h>
#include <stddef.h>

#include "flight/board_plans.h"
#include "flight/tuning.h"
#include "records/plan_record.h"
#include "records/record.h"

/// What is kept, each in a file of its own.
typedef enum
{
    board_keeps_parameters,
    board_keeps_own_gains,
    board_keeps_flight_plan,
    board_keeps_hil_plan,
    board_keeps_count
} board_keeps_t;

typedef struct
{
    const storage_t* storage;               ///< NULL: there is no card
    record_state_t kept[board_keeps_count]; ///< what became of each at the last load or store
    uint8_t room[plan_record_bytes];        ///< where a record is made or read
} board_card_t;

/// Nothing loaded or stored yet.
void board_card_init(board_card_t* card, const storage_t* storage);

/// Load what the card holds complete; anything else stays as it is. `is_silent`: the card did not answer just now, so
/// it is not asked again, and counts as unreadable until a store succeeds.
void board_card_load_parameters(board_card_t* card, bool is_silent, tuning_t* tuning);
void board_card_load_own_gains(board_card_t* card, bool is_silent, tuning_t* tuning);
void board_card_load_plans(board_card_t* card, bool is_silent, board_plans_t* plans);

/// Only read the parameters, or the own gains; the board does not fly by them yet. Needs the card, not the board.
record_state_t board_card_read_parameters(board_card_t* card, parameters_t* parameters);
record_state_t board_card_read_own_gains(board_card_t* card, tuning_t* tuning);

/// Copy what is to be kept; returns how many bytes that is. A plan counts as stored from here on.
size_t board_card_take(board_card_t* card, board_keeps_t what, const tuning_t* tuning, board_plans_t* plans);

/// Write what was taken to the card. Needs the card, not the board. `record_whole` when it is there.
record_state_t board_card_write(board_card_t* card, board_keeps_t what, size_t taken);

/// Remember how it ended; true when the card's alarm came or went by that.
bool board_card_note(board_card_t* card, board_keeps_t what, record_state_t state);

/// The next uploaded plan that is not taken yet, or `board_keeps_count`.
board_keeps_t board_card_next(const board_plans_t* plans);

/// True while something that the card should hold is damaged, newer than this firmware, unreadable or not written.
bool board_card_alarms(const board_card_t* card);

#endif

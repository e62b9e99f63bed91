#include "flight/board_card.h"

#include "flight/gains.h"
#include "records/parameter_record.h"

static const board_keeps_t kept_plans[board_plan_count] = {
    [board_plan_flight] = board_keeps_flight_plan,
    [board_plan_hil] = board_keeps_hil_plan,
};

static const plan_record_of_t plan_records[board_plan_count] = {
    [board_plan_flight] = plan_record_flight,
    [board_plan_hil] = plan_record_hil,
};

/// Which plan it is; not for the parameters.
static size_t plan_of(board_keeps_t what)
{
    return what == board_keeps_flight_plan ? (size_t)board_plan_flight : (size_t)board_plan_hil;
}

static record_state_t load_plan(board_t* board, size_t plan)
{
    return plan_record_load(board->config.storage, plan_records[plan], &board->plans[plan], board->card_room,
                            sizeof board->card_room);
}

void board_card_load(board_t* board)
{
    const board_config_t* const config = &board->config;
    const bool knows_plans = !config->legacy && !config->may_be_in_flight;
    if (config->storage != NULL)
    {
        const bool is_silent = config->card_is_silent;
        board->kept[board_keeps_parameters] =
            is_silent ? record_unreadable : board_card_read_parameters(board, &board->parameters);
        for (size_t plan = 0U; knows_plans && plan < (size_t)board_plan_count; plan++)
        {
            board->kept[kept_plans[plan]] = is_silent ? record_unreadable : load_plan(board, plan);
        }
    }
    board->gains = gains_of(&board->parameters);
}

record_state_t board_card_read_parameters(board_t* board, parameters_t* parameters)
{
    return parameter_record_load(board->config.storage, parameters, board->card_room, sizeof board->card_room);
}

size_t board_card_take(board_t* board, board_keeps_t what)
{
    if (what == board_keeps_parameters)
    {
        return parameter_record_take(&board->parameters, board->card_room);
    }
    board->plan_is_to_store[plan_of(what)] = false;
    return plan_record_take(&board->plans[plan_of(what)], board->card_room);
}

record_state_t board_card_write(board_t* board, board_keeps_t what, size_t taken)
{
    const storage_t* const storage = board->config.storage;
    if (what == board_keeps_parameters)
    {
        return parameter_record_save(storage, board->card_room, sizeof board->card_room, taken);
    }
    return plan_record_save(storage, plan_records[plan_of(what)], board->card_room, sizeof board->card_room, taken);
}

bool board_card_note(board_t* board, board_keeps_t what, record_state_t state)
{
    const bool alarmed = board_card_alarms(board);
    board->kept[what] = state;
    for (size_t other = 0U; state == record_whole && other < (size_t)board_keeps_count; other++)
    {
        if (board->kept[other] == record_unreadable)
        {
            // a card that can be written is readable again, and holds nothing else
            board->kept[other] = record_absent;
        }
    }
    return board_card_alarms(board) != alarmed;
}

board_keeps_t board_card_next(const board_t* board)
{
    for (size_t plan = 0U; plan < (size_t)board_plan_count; plan++)
    {
        if (board->plan_is_to_store[plan])
        {
            return kept_plans[plan];
        }
    }
    return board_keeps_count;
}

bool board_card_alarms(const board_t* board)
{
    for (size_t what = 0U; what < (size_t)board_keeps_count; what++)
    {
        if (record_is_alarming(board->kept[what]))
        {
            return true;
        }
    }
    return false;
}

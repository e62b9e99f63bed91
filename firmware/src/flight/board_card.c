#include "flight/board_card.h"

#include <string.h>

#include "flight/own_gains.h"
#include "records/gain_record.h"
#include "records/parameter_record.h"

static const board_keeps_t kept_plans[board_plan_count] = {
    [board_plan_flight] = board_keeps_flight_plan,
    [board_plan_hil] = board_keeps_hil_plan,
};

static const plan_record_of_t plan_records[board_plan_count] = {
    [board_plan_flight] = plan_record_flight,
    [board_plan_hil] = plan_record_hil,
};

/// Which plan it is; not for parameters and gains.
static size_t plan_of(board_keeps_t what)
{
    return what == board_keeps_flight_plan ? (size_t)board_plan_flight : (size_t)board_plan_hil;
}

void board_card_init(board_card_t* card, const storage_t* storage)
{
    memset(card, 0, sizeof *card);
    card->storage = storage;
}

void board_card_load_parameters(board_card_t* card, bool is_silent, tuning_t* tuning)
{
    parameters_t parameters = tuning->parameters;
    card->kept[board_keeps_parameters] = is_silent ? record_unreadable : board_card_read_parameters(card, &parameters);
    tuning_replace(tuning, &parameters);
}

void board_card_load_own_gains(board_card_t* card, bool is_silent, tuning_t* tuning)
{
    card->kept[board_keeps_own_gains] = is_silent ? record_unreadable : board_card_read_own_gains(card, tuning);
}

static record_state_t load_plan(board_card_t* card, size_t plan, board_plans_t* plans)
{
    return plan_record_load(card->storage, plan_records[plan], &plans->plan[plan], card->room, sizeof card->room);
}

void board_card_load_plans(board_card_t* card, bool is_silent, board_plans_t* plans)
{
    for (size_t plan = 0U; plan < (size_t)board_plan_count; plan++)
    {
        card->kept[kept_plans[plan]] = is_silent ? record_unreadable : load_plan(card, plan, plans);
    }
}

record_state_t board_card_read_parameters(board_card_t* card, parameters_t* parameters)
{
    return parameter_record_load(card->storage, parameters, card->room, sizeof card->room);
}

record_state_t board_card_read_own_gains(board_card_t* card, tuning_t* tuning)
{
    size_t count = 0U;
    const record_state_t state = gain_record_load(card->storage, card->room, sizeof card->room, &count);
    tuning_t read = *tuning;
    own_gain_t gain;
    for (size_t i = 0U; state == record_whole && own_gains_describe(i, &gain); i++)
    {
        float value = gain.default_value;
        (void)gain_record_find(card->room, count, gain.name, &value);
        if (!own_gains_set(&read, i, value))
        {
            return record_damaged;
        }
    }
    *tuning = read;
    return state;
}

/// Put all own gains into the room; how many bytes they are.
static size_t take_own_gains(board_card_t* card, const tuning_t* tuning)
{
    size_t taken = 0U;
    own_gain_t gain;
    for (size_t i = 0U; own_gains_describe(i, &gain); i++)
    {
        taken = gain_record_put(card->room, i, gain.name, own_gains_get(tuning, i));
    }
    return taken;
}

size_t board_card_take(board_card_t* card, board_keeps_t what, const tuning_t* tuning, board_plans_t* plans)
{
    if (what == board_keeps_parameters)
    {
        return parameter_record_take(&tuning->parameters, card->room);
    }
    if (what == board_keeps_own_gains)
    {
        return take_own_gains(card, tuning);
    }
    plans->is_to_store[plan_of(what)] = false;
    return plan_record_take(&plans->plan[plan_of(what)], card->room);
}

record_state_t board_card_write(board_card_t* card, board_keeps_t what, size_t taken)
{
    if (what == board_keeps_parameters)
    {
        return parameter_record_save(card->storage, card->room, sizeof card->room, taken);
    }
    if (what == board_keeps_own_gains)
    {
        return gain_record_save(card->storage, card->room, sizeof card->room, taken);
    }
    return plan_record_save(card->storage, plan_records[plan_of(what)], card->room, sizeof card->room, taken);
}

bool board_card_note(board_card_t* card, board_keeps_t what, record_state_t state)
{
    const bool alarmed = board_card_alarms(card);
    card->kept[what] = state;
    for (size_t other = 0U; state == record_whole && other < (size_t)board_keeps_count; other++)
    {
        if (card->kept[other] == record_unreadable)
        {
            // a card that can be written is readable again, and holds nothing else
            card->kept[other] = record_absent;
        }
    }
    return board_card_alarms(card) != alarmed;
}

board_keeps_t board_card_next(const board_plans_t* plans)
{
    for (size_t plan = 0U; plan < (size_t)board_plan_count; plan++)
    {
        if (plans->is_to_store[plan])
        {
            return kept_plans[plan];
        }
    }
    return board_keeps_count;
}

bool board_card_alarms(const board_card_t* card)
{
    for (size_t what = 0U; what < (size_t)board_keeps_count; what++)
    {
        if (record_is_alarming(card->kept[what]))
        {
            return true;
        }
    }
    return false;
}

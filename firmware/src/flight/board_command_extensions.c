#include "flight/board_command_extensions.h"

#include "flight/board_command_context.h"
#include "flight/board_streams.h"
#include "flight/description.h"
#include "flight/own_gains.h"

_Static_assert(COMMAND_MISSION_BEGIN_COUNT_MAXIMUM == plan_waypoints_max, "the longest mission fits a plan");

command_result_t run_tell_capabilities(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    (void)payload;
    board_t* const board = board_of(context);
    board->station.is_extended = true;
    board_send_capabilities(board, ((board_command_context_t*)context)->now_ms);
    return command_done;
}

command_result_t run_tell_steps(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    (void)payload;
    board_of(context)->station.wants_steps = true;
    return command_done;
}

command_result_t run_describe(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    (void)payload;
    const board_t* const board = board_of(context);
    report_description(&board->line, &board->table);
    return command_done;
}

command_result_t run_describe_blocks(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    board_t* const board = board_of(context);
    command_describe_blocks_t asked;
    command_describe_blocks_unpack(&asked, payload);
    if (asked.first < 0 || asked.count < COMMAND_DESCRIBE_BLOCKS_COUNT_MINIMUM ||
        asked.count > COMMAND_DESCRIBE_BLOCKS_COUNT_MAXIMUM)
    {
        return command_bad_value;
    }
    // the blocks follow one by one with the tick, so that they do not delay the HIL answers
    return description_begin_reading(&board->reading, board->table.size, (size_t)asked.first, (size_t)asked.count)
               ? command_done
               : command_bad_value;
}

command_result_t run_switch_own_topics(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    const int32_t on = protocol_get_i32(payload);
    if (on != COMMAND_OWN_TOPICS_ON_OFF && on != COMMAND_OWN_TOPICS_ON_ON)
    {
        return command_bad_value;
    }
    const uint32_t now_ms = ((board_command_context_t*)context)->now_ms;
    own_topics_switch(&board_of(context)->own_topics, on == COMMAND_OWN_TOPICS_ON_ON, now_ms);
    return command_done;
}

command_result_t run_get_own_gain(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    const board_t* const board = board_of(context);
    const size_t row = (size_t)protocol_get_u32(payload);
    if (row >= own_gains_count())
    {
        return command_bad_value;
    }
    report_own_gain(&board->line, row, own_gains_get(&board->tuning, row));
    return command_done;
}

command_result_t run_set_own_gain(void* context, int32_t argument, const uint8_t* payload)
{
    board_t* const board = board_of(context);
    command_own_gain_set_t values;
    command_own_gain_set_unpack(&values, payload);
    const bool is_set = values.row >= 0 && own_gains_set(&board->tuning, (size_t)values.row, values.value);
    // the row is first in both payloads; the value that the board has is told after a refusal too
    const command_result_t told = run_get_own_gain(context, argument, payload);
    return is_set ? told : command_bad_value;
}

/// Write one thing to the card; whether it is there.
static bool store(board_t* board, board_keeps_t what)
{
    board_card_t* const card = &board->card;
    const size_t taken = board_card_take(card, what, &board->tuning, &board->plans);
    const record_state_t state = board_card_write(card, what, taken);
    (void)board_card_note(card, what, state);
    return state == record_whole;
}

command_result_t run_store_parameters(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    (void)payload;
    board_t* const board = board_of(context);
    if (board->card.storage == NULL)
    {
        return command_storage_failed;
    }
    const bool has_parameters = store(board, board_keeps_parameters);
    const bool has_gains = store(board, board_keeps_own_gains);
    return has_parameters && has_gains ? command_done : command_storage_failed;
}

command_result_t run_select_airspeed(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    const int32_t source = protocol_get_i32(payload);
    if (source != COMMAND_SELECT_AIRSPEED_SOURCE_SOURCE_GPS && source != COMMAND_SELECT_AIRSPEED_SOURCE_SOURCE_PITOT)
    {
        return command_bad_value;
    }
    board_of(context)->flight.airspeed_source = source;
    return command_done;
}

command_result_t run_select_altitude(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    const int32_t source = protocol_get_i32(payload);
    if (source != COMMAND_SELECT_ALTITUDE_SOURCE_SOURCE_GPS &&
        source != COMMAND_SELECT_ALTITUDE_SOURCE_SOURCE_BAROMETER)
    {
        return command_bad_value;
    }
    board_of(context)->flight.altitude_source = source;
    return command_done;
}

static command_result_t result_of(mission_status_t status)
{
    switch (status)
    {
    case mission_ok:
        return command_done;
    case mission_bad_value:
        return command_bad_value;
    case mission_bad_state:
        break;
    }
    return command_bad_state;
}

command_result_t run_begin_mission(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    command_mission_begin_t values;
    command_mission_begin_unpack(&values, payload);
    if (!board_plans_has(values.plan))
    {
        return command_bad_value;
    }
    return result_of(mission_begin(&board_of(context)->plans.upload, values.plan, values.count));
}

command_result_t run_take_mission_item(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    command_mission_item_t values;
    command_mission_item_unpack(&values, payload);
    if (!board_plans_has(values.plan))
    {
        return command_bad_value;
    }
    const waypoint_t waypoint = {
        .position = {values.latitude_deg, values.longitude_deg},
        .altitude_ft = values.altitude_ft,
        .speed_kt = values.speed_kt,
    };
    return result_of(mission_item(&board_of(context)->plans.upload, values.plan, values.index, &waypoint));
}

command_result_t run_commit_mission(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    board_t* const board = board_of(context);
    const int32_t plan = protocol_get_i32(payload);
    if (!board_plans_has(plan))
    {
        return command_bad_value;
    }
    return result_of(board_plans_commit(&board->plans, plan, board->card.storage != NULL));
}

command_result_t run_read_mission(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    board_t* const board = board_of(context);
    const int32_t plan = protocol_get_i32(payload);
    if (!board_plans_has(plan))
    {
        return command_bad_value;
    }
    // the items follow one by one with the tick, so that a long plan does not delay the HIL answers
    report_mission_count(&board->line, plan, board->plans.plan[plan].count);
    board_plans_begin_reading(&board->plans, plan);
    return command_done;
}

command_result_t run_go_to_waypoint(void* context, int32_t argument, const uint8_t* payload)
{
    (void)argument;
    command_go_to_waypoint_t values;
    command_go_to_waypoint_unpack(&values, payload);
    if (!board_plans_has(values.plan))
    {
        return command_bad_value;
    }
    plan_t* const plan = &board_of(context)->plans.plan[values.plan];
    if (plan->count == 0)
    {
        return command_bad_state;
    }
    return plan_go_to(plan, values.index) ? command_done : command_bad_value;
}

// Mission transfer against a model of it: which plan may replace another one, and when. The plan in use is either the
// earlier one or the complete uploaded one, and each command is answered as the model says.
#include "fuzz.h"

#include <string.h>

#include "navigation/routes_gen.h"
#include "support/random.h"
#include "support/rig.h"

typedef struct
{
    waypoint_t waypoints[plan_waypoints_max];
    size_t count;
    bool loop;
} model_plan_t;

typedef struct
{
    model_plan_t plans[board_plan_count]; ///< in use
    int32_t upload;                       ///< plan that is being uploaded, -1: none
    model_plan_t staged;
    bool is_there[plan_waypoints_max];
} model_t;

static rig_t* rig;
static model_t model;

static bool is_plan(int32_t plan)
{
    return plan == board_plan_flight || plan == board_plan_hil;
}

static bool is_between(double value, double least, double most)
{
    return value >= least && value <= most;
}

static command_result_t begin(const uint8_t* payload)
{
    const int32_t plan = protocol_get_i32(payload);
    const int32_t count = protocol_get_i32(payload + 4);
    if (!is_plan(plan) || count < 1 || count > 100)
    {
        return command_bad_value;
    }
    model.upload = plan;
    model.staged = (model_plan_t){.count = (size_t)count};
    memset(model.is_there, 0, sizeof model.is_there);
    return command_done;
}

static command_result_t stage(const uint8_t* payload)
{
    command_mission_item_t item;
    command_mission_item_unpack(&item, payload);
    if (!is_plan(item.plan))
    {
        return command_bad_value;
    }
    if (model.upload != item.plan)
    {
        return command_bad_state;
    }
    const bool can_be_flown =
        is_between(item.latitude_deg, -90.0, 90.0) && is_between(item.longitude_deg, -180.0, 180.0) &&
        is_between((double)item.altitude_ft, -2000.0, 60000.0) && is_between((double)item.speed_kt, 0.0, 500.0);
    if (item.index < 0 || (size_t)item.index >= model.staged.count || !can_be_flown)
    {
        return command_bad_value;
    }
    model.staged.waypoints[item.index] = (waypoint_t){
        .position = {item.latitude_deg, item.longitude_deg},
        .altitude_ft = item.altitude_ft,
        .speed_kt = item.speed_kt,
    };
    model.is_there[item.index] = true;
    return command_done;
}

static command_result_t commit(const uint8_t* payload)
{
    const int32_t plan = protocol_get_i32(payload);
    if (!is_plan(plan))
    {
        return command_bad_value;
    }
    bool is_whole = model.upload == plan;
    for (size_t i = 0; i < model.staged.count; i++)
    {
        is_whole = is_whole && model.is_there[i];
    }
    if (!is_whole)
    {
        return command_bad_state;
    }
    model.plans[plan] = model.staged;
    model.upload = -1;
    return command_done;
}

static void load_route(const route_t* route)
{
    model_plan_t* const plan = &model.plans[board_plan_hil];
    *plan = (model_plan_t){.count = route->count, .loop = route->loop};
    for (size_t i = 0; i < route->count; i++)
    {
        const route_waypoint_t* const from = &route->waypoints[i];
        plan->waypoints[i] = (waypoint_t){{from->latitude_deg, from->longitude_deg}, from->altitude_ft, from->speed_kt};
    }
}

/// The expected answer to the command; -1: the model does not know.
static int model_answer(const frame_t* frame)
{
    switch (frame->type_id)
    {
    case COMMAND_MISSION_BEGIN_ID:
        return (int)begin(frame->payload);
    case COMMAND_MISSION_ITEM_ID:
        return (int)stage(frame->payload);
    case COMMAND_MISSION_COMMIT_ID:
        return (int)commit(frame->payload);
    case COMMAND_MISSION_READ_ID:
        return (int)(is_plan(protocol_get_i32(frame->payload)) ? command_done : command_bad_value);
    default:
        break;
    }
    for (size_t i = 0; i < ROUTE_COUNT; i++)
    {
        if (frame->type_id == routes[i].load_command)
        {
            load_route(&routes[i]);
        }
    }
    return -1;
}

static bool is_same_waypoint(const waypoint_t* one, const waypoint_t* other)
{
    return memcmp(one, other, sizeof *one) == 0;
}

static void require_plans(void)
{
    for (size_t i = 0; i < board_plan_count; i++)
    {
        const plan_t* const plan = &rig->board.plans.plan[i];
        const model_plan_t* const expected = &model.plans[i];
        fuzz_require(plan->count == expected->count && plan->loop == expected->loop,
                     "a plan changes completely or not at all");
        fuzz_require(plan->count == 0U ? plan->current == 0U : plan->current < plan->count,
                     "the current waypoint exists");
        for (size_t k = 0; k < plan->count; k++)
        {
            fuzz_require(is_same_waypoint(&plan->waypoints[k], &expected->waypoints[k]),
                         "every waypoint is the expected one");
        }
    }
}

/// Read a plan back to its end: every waypoint of the plan in use comes, in order.
static void require_read_back(size_t number)
{
    line_clear(&rig->out);
    (void)rig_do_with(rig, COMMAND_MISSION_READ_ID, (int32_t)number);
    while (board_tick(&rig->board, rig->now_ms))
    {
    }
    const model_plan_t* const plan = &model.plans[number];
    size_t at = 0U;
    for (size_t i = 0; i < rig->out.count; i++)
    {
        const line_frame_t* const frame = &rig->out.frames[i];
        if (frame->type_id == MESSAGE_MISSION_COUNT_ID)
        {
            fuzz_require(protocol_get_i32(frame->payload + 4) == (int32_t)plan->count, "the count that is announced");
        }
        if (frame->type_id != MESSAGE_MISSION_ITEM_ID)
        {
            continue;
        }
        message_mission_item_t item;
        message_mission_item_unpack(&item, frame->payload);
        const waypoint_t waypoint = {{item.latitude_deg, item.longitude_deg}, item.altitude_ft, item.speed_kt};
        fuzz_require(item.plan == (int32_t)number && item.index == (int32_t)at && at < plan->count,
                     "items are read back in order");
        fuzz_require(is_same_waypoint(&waypoint, &plan->waypoints[at]), "a plan is read back as it is flown");
        at++;
    }
    fuzz_require(at == plan->count, "a plan is read back to its last waypoint");
}

static void hear_command(const frame_t* frame, fuzz_input_t* input)
{
    rig->now_ms += random_below(&input->random, 30U);
    const int expected = model_answer(frame);
    const int answer = rig_ask(rig, frame->type_id, frame->payload, frame->payload_size);
    fuzz_require(expected < 0 || answer == expected, "a mission command is answered as the model says");
    (void)board_tick(&rig->board, rig->now_ms);
    require_plans();
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    fuzz_input_t input;
    if (!fuzz_read_input(&input, bytes, size))
    {
        return 0;
    }
    static frame_decoder_t decoder;
    frame_decoder_init(&decoder, &board_frames_in);
    memset(&model, 0, sizeof model);
    model.upload = -1;
    rig = rig_start_without_card();
    rig_extend(rig);
    while (input.line_size > 0U)
    {
        const size_t taken = frame_decoder_feed(&decoder, input.line, input.line_size);
        input.line += taken;
        input.line_size -= taken;
        frame_t frame;
        for (frame_event_t event = frame_decoder_next(&decoder, &frame); event != frame_event_none;
             event = frame_decoder_next(&decoder, &frame))
        {
            if (event == frame_event_frame)
            {
                hear_command(&frame, &input);
            }
        }
    }
    for (size_t i = 0; i < board_plan_count; i++)
    {
        require_read_back(i);
    }
    return 0;
}

#include "support/cmocka_all.h"

#include <string.h>

#include "common/bytes.h"
#include "flight/own_gains.h"
#include "flight/own_topics.h"
#include "support/rig.h"

enum
{
    wind_word = 0x1000,
    line_law_word = 0x1001,
    law_row = 0
};

/// The newest frame of each topic and how many came: no decoder knows their types without the board's description.
typedef struct
{
    size_t count;
    size_t size;
    uint8_t payload[own_topic_payload_max_bytes];
} heard_t;

static heard_t heard[own_topic_count];

static void hear(void* context, const uint8_t* frame, size_t size)
{
    (void)context;
    const uint32_t type_id = bytes_read_u32(frame + 4) & 0x0FFFFFFFU;
    if (type_id < wind_word || type_id > line_law_word)
    {
        return;
    }
    heard_t* const topic = &heard[type_id - wind_word];
    topic->count++;
    topic->size = size - frame_overhead_bytes;
    assert_true(topic->size <= sizeof topic->payload);
    memcpy(topic->payload, frame + 8, topic->size);
    uint32_t sum = 0;
    for (size_t at = 4; at + 4 < size; at += 4)
    {
        sum += bytes_read_u32(frame + at);
    }
    assert_int_equal(sum, 0);
}

static rig_t* begin(void)
{
    rig_t* const rig = rig_start();
    rig->board.line = (report_line_t){.send = hear};
    memset(heard, 0, sizeof heard);
    return rig;
}

static command_result_t switch_topics(rig_t* rig, int32_t on)
{
    uint8_t payload[COMMAND_OWN_TOPICS_SIZE];
    protocol_put_i32(payload, on);
    return board_run_command(&rig->board, COMMAND_OWN_TOPICS_ID, payload, sizeof payload, rig->now_ms);
}

/// Let `ms` pass, a tick each 10 of them.
static void wait_for(rig_t* rig, uint32_t ms)
{
    for (uint32_t passed = 0; passed < ms; passed += 10)
    {
        (void)board_tick(&rig->board, rig->now_ms);
        rig->now_ms += 10;
    }
}

static float value(own_topic_id_t topic, size_t field)
{
    return bytes_read_f32(heard[topic].payload + 4 * field);
}

/// Fly north-east along a plan for `seconds`, with a wind of 10 kt from behind.
static void fly(rig_t* rig, double seconds)
{
    command_xplane_info_t info = rig_level_flight();
    for (int i = 0; i < (int)(seconds * 50.0); i++)
    {
        info.latitude_deg += 8.6e-6F;
        // a simulator's roll and altitude never stand still
        info.altitude_ft = 1000.0F + 0.01F * (float)(i % 7);
        uint8_t payload[COMMAND_XPLANE_INFO_SIZE];
        info.yaw_deg = 0.0F;
        command_xplane_info_pack(&info, payload);
        rig->now_ms += 20;
        (void)board_run_command(&rig->board, COMMAND_XPLANE_INFO_ID, payload, sizeof payload, rig->now_ms);
        board_supervise_hil(&rig->board, rig->now_ms);
    }
}

static void choose_line_law(rig_t* rig)
{
    (void)board_run_command(&rig->board, COMMAND_HIL_LOAD_GANDO_ID, NULL, 0, rig->now_ms);
    rig->board.hil.source = control_source_joystick;
    (void)board_run_command(&rig->board, COMMAND_AUTOPILOT_ON_ID, NULL, 0, rig->now_ms);
    assert_true(own_gains_set(&rig->board.tuning, law_row, (float)guidance_law_line));
}

static void they_come_at_once_and_then_each_in_its_period(void** state)
{
    (void)state;
    rig_t* const rig = begin();
    wait_for(rig, 2000);
    assert_int_equal(heard[own_topic_wind].count + heard[own_topic_line_law].count, 0);
    assert_int_equal(switch_topics(rig, 1), command_done);
    wait_for(rig, 10);
    assert_int_equal(heard[own_topic_wind].count, 1);
    assert_int_equal(heard[own_topic_line_law].count, 1);
    wait_for(rig, 10000);
    assert_int_equal(heard[own_topic_wind].count, 21);
    assert_int_equal(heard[own_topic_line_law].count, 51);
    assert_int_equal(switch_topics(rig, 1), command_done);
    wait_for(rig, 100);
    assert_int_equal(heard[own_topic_line_law].count, 51);
}

static void they_end_where_they_are_switched_off_and_where_the_line_is_opened_again(void** state)
{
    (void)state;
    rig_t* const rig = begin();
    assert_int_equal(switch_topics(rig, 1), command_done);
    wait_for(rig, 10);
    assert_int_equal(switch_topics(rig, 0), command_done);
    wait_for(rig, 1000);
    assert_int_equal(heard[own_topic_wind].count, 1);
    assert_int_equal(switch_topics(rig, 1), command_done);
    board_open(&rig->board, rig->now_ms);
    wait_for(rig, 1000);
    assert_int_equal(heard[own_topic_wind].count, 1);
}

static void a_state_that_is_neither_on_nor_off_is_refused(void** state)
{
    (void)state;
    rig_t* const rig = begin();
    assert_int_equal(switch_topics(rig, 2), command_bad_value);
    assert_int_equal(switch_topics(rig, -1), command_bad_value);
    wait_for(rig, 1000);
    assert_int_equal(heard[own_topic_wind].count, 0);
}

static void after_a_gap_they_are_not_made_up_for(void** state)
{
    (void)state;
    rig_t* const rig = begin();
    assert_int_equal(switch_topics(rig, 1), command_done);
    wait_for(rig, 10);
    rig->now_ms += 100000;
    wait_for(rig, 200);
    assert_int_equal(heard[own_topic_line_law].count, 2);
}

static void assert_nothing_is_known(void)
{
    assert_int_equal(heard[own_topic_wind].size, 12);
    assert_int_equal(heard[own_topic_line_law].size, 20);
    for (size_t field = 0; field < 3; field++)
    {
        assert_true(isnan(value(own_topic_wind, field)));
    }
    for (size_t field = 0; field < 4; field++)
    {
        assert_true(isnan(value(own_topic_line_law, field)));
    }
    assert_int_equal(bytes_read_u32(heard[own_topic_line_law].payload + 16), 0);
}

static void nothing_is_known_before_the_line_law_flies(void** state)
{
    (void)state;
    rig_t* const rig = begin();
    assert_int_equal(switch_topics(rig, 1), command_done);
    wait_for(rig, 10);
    assert_nothing_is_known();
    (void)board_run_command(&rig->board, COMMAND_HIL_LOAD_GANDO_ID, NULL, 0, rig->now_ms);
    fly(rig, 5.0);
    wait_for(rig, 10);
    assert_nothing_is_known();
}

static void they_tell_what_the_line_law_holds_and_the_wind_that_it_found(void** state)
{
    (void)state;
    rig_t* const rig = begin();
    choose_line_law(rig);
    fly(rig, 20.0);
    assert_int_equal(switch_topics(rig, 1), command_done);
    wait_for(rig, 10);
    const line_law_t* const law = &rig->board.hil.loop.line;
    wind_estimate_t wind;
    assert_true(wind_estimate(&law->legs.wind, &wind));
    assert_close(value(own_topic_wind, 0), wind.from_deg, 0.0);
    assert_close(value(own_topic_wind, 1), wind.speed_m_s / 0.514444F, 0.001);
    assert_close(value(own_topic_wind, 2), wind.deviation_m_s / 0.514444F, 0.001);
    assert_true(wind.speed_m_s > 5.0F);
    assert_close(value(own_topic_line_law, 0), law->target.right_m, 0.0);
    assert_true(fabsf(law->target.right_m) > 1.0F);
    assert_close(value(own_topic_line_law, 1), law->target.course_deg, 0.001);
    assert_close(value(own_topic_line_law, 2), law->follow.roll_d_deg, 0.0);
    assert_close(value(own_topic_line_law, 3), 93.0, 10.0);
    assert_int_equal(bytes_read_u32(heard[own_topic_line_law].payload + 16), law->is_slow ? 1 : 0);
}

static void the_wind_is_known_while_the_pilot_flies_and_what_the_law_holds_is_not(void** state)
{
    (void)state;
    rig_t* const rig = begin();
    choose_line_law(rig);
    (void)board_run_command(&rig->board, COMMAND_AUTOPILOT_OFF_ID, NULL, 0, rig->now_ms);
    fly(rig, 20.0);
    assert_int_equal(switch_topics(rig, 1), command_done);
    wait_for(rig, 10);
    assert_true(isfinite(value(own_topic_wind, 0)));
    assert_true(isnan(value(own_topic_line_law, 0)));
    assert_true(isnan(value(own_topic_line_law, 3)));
}

static void a_slow_flight_has_its_flag_while_there_is_a_line(void** state)
{
    (void)state;
    rig_t* const rig = begin();
    choose_line_law(rig);
    fly(rig, 1.0);
    rig->board.hil.loop.line.is_slow = true;
    uint8_t payload[own_topic_payload_max_bytes];
    const own_topics_source_t source = {.loop = &rig->board.hil.loop, .has_line = true};
    assert_int_equal(own_topics_payload(own_topic_line_law, &source, payload), 20);
    assert_int_equal(bytes_read_u32(payload + 16), 1);
    const own_topics_source_t lineless = {.loop = &rig->board.hil.loop, .has_line = false};
    assert_int_equal(own_topics_payload(own_topic_line_law, &lineless, payload), 20);
    assert_int_equal(bytes_read_u32(payload + 16), 0);
    assert_true(isnan(bytes_read_f32(payload)));
    assert_true(isfinite(bytes_read_f32(payload + 4)));
}

static void a_silent_simulator_leaves_nothing_that_looks_live(void** state)
{
    (void)state;
    rig_t* const rig = begin();
    choose_line_law(rig);
    fly(rig, 20.0);
    assert_int_equal(switch_topics(rig, 1), command_done);
    wait_for(rig, 10);
    assert_true(isfinite(value(own_topic_wind, 0)));
    rig->now_ms += 5000;
    board_supervise_hil(&rig->board, rig->now_ms);
    wait_for(rig, 10);
    assert_nothing_is_known();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(they_come_at_once_and_then_each_in_its_period),
        cmocka_unit_test(they_end_where_they_are_switched_off_and_where_the_line_is_opened_again),
        cmocka_unit_test(a_state_that_is_neither_on_nor_off_is_refused),
        cmocka_unit_test(after_a_gap_they_are_not_made_up_for),
        cmocka_unit_test(nothing_is_known_before_the_line_law_flies),
        cmocka_unit_test(they_tell_what_the_line_law_holds_and_the_wind_that_it_found),
        cmocka_unit_test(the_wind_is_known_while_the_pilot_flies_and_what_the_law_holds_is_not),
        cmocka_unit_test(a_slow_flight_has_its_flag_while_there_is_a_line),
        cmocka_unit_test(a_silent_simulator_leaves_nothing_that_looks_live),
    };
    return cmocka_run_group_tests_name("flight.own_topics", tests, NULL, NULL);
}

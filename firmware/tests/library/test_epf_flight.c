#include "support/cmocka_all.h"

#include <string.h>

#include "comms/protocol_gen.h"
#include "epf_flight.h"
#include "support/line.h"

enum
{
    out_bytes = 65536
};

static size_t send(flight_t* flight, line_t* line, uint32_t type_id, const uint8_t* payload, size_t size)
{
    uint8_t frame[frame_max_bytes];
    static uint8_t out[out_bytes];
    const size_t length = frame_encode(&frame_to_board, type_id, payload, size, frame, sizeof frame);
    const size_t given = epf_flight_feed(flight, frame, length, out, sizeof out);
    line_feed(line, out, given, 0);
    return given;
}

static void a_command_50_comes_back_as_surfaces(void** state)
{
    (void)state;
    flight_t* const flight = epf_flight_new(0.02F);
    static line_t line;
    line_init(&line, &frame_from_board);
    const uint8_t payload[COMMAND_XPLANE_INFO_SIZE] = {0};
    (void)send(flight, &line, COMMAND_XPLANE_INFO_ID, payload, sizeof payload);
    assert_int_equal(line.count, 1);
    assert_int_equal(line.frames[0].type_id, MESSAGE_HIL_SURFACES_ID);
    epf_flight_free(flight);
}

static void a_whole_plan_is_read_back_in_one_go(void** state)
{
    (void)state;
    flight_t* const flight = epf_flight_new(0.02F);
    static line_t line;
    line_init(&line, &frame_from_board);
    (void)send(flight, &line, COMMAND_HIL_LOAD_RUTA_ISLA_ID, NULL, 0);
    uint8_t payload[4];
    protocol_put_i32(payload, 1);
    (void)send(flight, &line, COMMAND_MISSION_READ_ID, payload, sizeof payload);
    assert_int_equal(line_count_of(&line, MESSAGE_MISSION_ITEM_ID), 20);
    epf_flight_free(flight);
}

static void what_does_not_fit_comes_with_the_next_call(void** state)
{
    (void)state;
    flight_t* const flight = epf_flight_new(0.02F);
    uint8_t frame[frame_max_bytes];
    const size_t length = frame_encode(&frame_to_board, COMMAND_READ_ALL_ID, NULL, 0, frame, sizeof frame);
    static line_t line;
    line_init(&line, &frame_from_board);
    uint8_t out[7];
    size_t given = epf_flight_feed(flight, frame, length, out, sizeof out);
    while (given > 0)
    {
        line_feed(&line, out, given, 0);
        given = epf_flight_feed(flight, NULL, 0, out, sizeof out);
    }
    assert_int_equal(line.count, 10);
    assert_int_equal(frame_decoder_rejected(&line.decoder), 0);
    assert_int_equal(epf_flight_lost_bytes(flight), 0);
    epf_flight_free(flight);
}

static void bytes_that_nobody_takes_are_counted_and_never_overrun(void** state)
{
    (void)state;
    flight_t* const flight = epf_flight_new(0.02F);
    uint8_t frame[frame_max_bytes];
    const size_t length = frame_encode(&frame_to_board, COMMAND_READ_ALL_ID, NULL, 0, frame, sizeof frame);
    for (int i = 0; i < 200; i++)
    {
        (void)epf_flight_feed(flight, frame, length, NULL, 0);
    }
    assert_true(epf_flight_lost_bytes(flight) > 0);
    epf_flight_free(flight);
}

static void time_brings_the_status_and_streams_their_frames(void** state)
{
    (void)state;
    flight_t* const flight = epf_flight_new(0.02F);
    static line_t line;
    line_init(&line, &frame_from_board);
    (void)send(flight, &line, COMMAND_CAPABILITIES_ID, NULL, 0);
    (void)send(flight, &line, COMMAND_FMS_HIL_PLAN_ON_ID, NULL, 0);
    line_clear(&line);
    static uint8_t out[out_bytes];
    epf_flight_advance(flight, 1000);
    epf_flight_send_streams(flight, 1);
    epf_flight_send_streams(flight, 99); // no such task
    line_feed(&line, out, epf_flight_feed(flight, NULL, 0, out, sizeof out), 0);
    assert_int_equal(line_count_of(&line, MESSAGE_BOARD_STATUS_ID), 1);
    assert_int_equal(line_count_of(&line, MESSAGE_FMS_HIL_PLAN_ID), 1);
    assert_int_equal(line.count, 2);
    epf_flight_free(flight);
}

static void a_greeting_makes_the_station_ask_anew(void** state)
{
    (void)state;
    flight_t* const flight = epf_flight_new(0.02F);
    static line_t line;
    line_init(&line, &frame_from_board);
    (void)send(flight, &line, COMMAND_CAPABILITIES_ID, NULL, 0);
    static uint8_t out[out_bytes];
    assert_int_equal(epf_flight_feed(flight, (const uint8_t*)PROTOCOL_OPEN_BINARY_MODE, 4, out, sizeof out), 0);
    line_clear(&line);
    (void)send(flight, &line, COMMAND_AHRS_ON_ID, NULL, 0);
    assert_int_equal(line.count, 0);
    epf_flight_free(flight);
}

static void the_same_bytes_in_give_the_same_bytes_out(void** state)
{
    (void)state;
    static uint8_t out[2][out_bytes];
    size_t given[2];
    for (int run = 0; run < 2; run++)
    {
        flight_t* const flight = epf_flight_new(0.02F);
        given[run] = 0;
        for (int i = 0; i < 500; i++)
        {
            command_xplane_info_t info = {.elevator = (float)i / 500.0F, .speed_kt = 55.0F, .gx_rad_s = 0.1F};
            info.altitude_ft = 1000.0F + (float)i;
            uint8_t payload[COMMAND_XPLANE_INFO_SIZE];
            command_xplane_info_pack(&info, payload);
            uint8_t frame[frame_max_bytes];
            const size_t size =
                frame_encode(&frame_to_board, COMMAND_XPLANE_INFO_ID, payload, sizeof payload, frame, sizeof frame);
            given[run] += epf_flight_feed(flight, frame, size, out[run] + given[run], out_bytes - given[run]);
        }
        epf_flight_free(flight);
    }
    assert_int_equal(given[0], 500 * 32);
    assert_int_equal(given[1], given[0]);
    assert_memory_equal(out[0], out[1], given[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_command_50_comes_back_as_surfaces),
        cmocka_unit_test(a_whole_plan_is_read_back_in_one_go),
        cmocka_unit_test(what_does_not_fit_comes_with_the_next_call),
        cmocka_unit_test(bytes_that_nobody_takes_are_counted_and_never_overrun),
        cmocka_unit_test(time_brings_the_status_and_streams_their_frames),
        cmocka_unit_test(a_greeting_makes_the_station_ask_anew),
        cmocka_unit_test(the_same_bytes_in_give_the_same_bytes_out),
    };
    return cmocka_run_group_tests_name("library.epf_flight", tests, NULL, NULL);
}

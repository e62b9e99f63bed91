#include "support/cmocka_all.h"

#include <string.h>

#include "comms/frame.h"
#include "comms/protocol_gen.h"
#include "support/line.h"
#include "support/random.h"

enum
{
    stream_max_bytes = 4096
};

typedef struct
{
    uint8_t bytes[stream_max_bytes];
    size_t size;
} stream_t;

static void add_bytes(stream_t* stream, const void* bytes, size_t size)
{
    assert_true(stream->size + size <= sizeof stream->bytes);
    memcpy(stream->bytes + stream->size, bytes, size);
    stream->size += size;
}

static void add_ahrs(stream_t* stream, float yaw_deg)
{
    const message_ahrs_t values = {.yaw_deg = yaw_deg, .pitch_deg = 1.0F, .roll_deg = -2.0F};
    uint8_t payload[MESSAGE_AHRS_SIZE];
    message_ahrs_pack(&values, payload);
    uint8_t frame[frame_max_bytes];
    add_bytes(stream, frame,
              frame_encode(&frame_from_board, MESSAGE_AHRS_ID, payload, sizeof payload, frame, sizeof frame));
}

static void an_encoded_frame_has_the_bytes_of_a_captured_one(void** state)
{
    (void)state;
    // captured: Autopilot On of the deployed station
    const uint8_t captured[] = {0x23, 0x51, 0x54, 0x2C, 0x25, 0, 0, 0, 0xDB, 0xFF, 0xFF, 0xFF, 0x0D, 0x0A, 0x0D, 0x0A};
    uint8_t frame[frame_max_bytes];
    const size_t size = frame_encode(&frame_to_board, COMMAND_AUTOPILOT_ON_ID, NULL, 0, frame, sizeof frame);
    assert_int_equal(size, sizeof captured);
    assert_memory_equal(frame, captured, sizeof captured);
}

static void a_frame_that_does_not_fit_is_not_written(void** state)
{
    (void)state;
    uint8_t payload[frame_payload_max_bytes + 4] = {0};
    uint8_t frame[frame_max_bytes + 4];
    memset(frame, 0xA5, sizeof frame);
    assert_int_equal(frame_encode(&frame_to_board, 1, NULL, 0, frame, frame_overhead_bytes - 1), 0);
    assert_int_equal(frame_encode(&frame_to_board, 1, payload, 6, frame, sizeof frame), 0);
    assert_int_equal(frame_encode(&frame_to_board, 1, payload, sizeof payload, frame, sizeof frame), 0);
    assert_int_equal(frame[0], 0xA5);
}

static void cut_points_do_not_matter(void** state)
{
    (void)state;
    stream_t stream = {.size = 0};
    add_bytes(&stream, "noise\rQT", 8);
    add_ahrs(&stream, 10.0F);
    add_bytes(&stream, "\rQT,\r\n\r\n", 8);
    add_ahrs(&stream, 20.0F);
    static line_t whole;
    line_init(&whole, &frame_from_board);
    line_feed(&whole, stream.bytes, stream.size, 0);
    assert_int_equal(whole.count, 2);
    for (size_t cut = 0; cut <= stream.size; cut++)
    {
        static line_t line;
        line_init(&line, &frame_from_board);
        line_feed(&line, stream.bytes, cut, 0);
        line_feed(&line, stream.bytes + cut, stream.size - cut, 0);
        assert_int_equal(line.count, whole.count);
        assert_memory_equal(line.frames, whole.frames, whole.count * sizeof whole.frames[0]);
        assert_memory_equal(line.decoder.damage, whole.decoder.damage, sizeof whole.decoder.damage);
        assert_int_equal(line.decoder.noise_bytes, whole.decoder.noise_bytes);
    }
}

static void noise_never_hides_the_next_frame(void** state)
{
    (void)state;
    uint32_t seed = 1;
    for (int round = 0; round < 2000; round++)
    {
        stream_t stream = {.size = 0};
        const uint32_t length = random_below(&seed, 300);
        for (uint32_t i = 0; i < length; i++)
        {
            // many bytes of headers and end markers among the noise
            const uint8_t byte = random_below(&seed, 2) == 0 ? (uint8_t)"\rQT,\n#"[random_below(&seed, 6)]
                                                             : (uint8_t)random_below(&seed, 256);
            add_bytes(&stream, &byte, 1);
        }
        add_ahrs(&stream, 33.0F);
        // a false header with a plausible type holds the decoder for the length of that frame, not longer
        const uint8_t silence[frame_max_bytes] = {0};
        add_bytes(&stream, silence, sizeof silence);
        static line_t line;
        line_init(&line, &frame_from_board);
        line_feed(&line, stream.bytes, stream.size, 1 + random_below(&seed, 40));
        const line_frame_t* const found = line_newest(&line, MESSAGE_AHRS_ID);
        assert_non_null(found);
        message_ahrs_t values;
        message_ahrs_unpack(&values, found->payload);
        assert_close(values.yaw_deg, 33.0F, 0.0);
    }
}

static void every_single_flipped_bit_is_refused_and_costs_only_its_frame(void** state)
{
    (void)state;
    stream_t stream = {.size = 0};
    add_ahrs(&stream, 1.0F);
    const size_t first = stream.size;
    add_ahrs(&stream, 2.0F);
    add_ahrs(&stream, 3.0F);
    add_ahrs(&stream, 4.0F);
    for (size_t bit = 0; bit < 8 * first; bit++)
    {
        stream.bytes[bit / 8] ^= (uint8_t)(1U << (bit % 8));
        static line_t line;
        line_init(&line, &frame_from_board);
        line_feed(&line, stream.bytes, stream.size, 0);
        line_expire(&line);
        assert_int_equal(line.count, 3);
        for (size_t i = 0; i < 3; i++)
        {
            message_ahrs_t values;
            message_ahrs_unpack(&values, line.frames[i].payload);
            assert_close(values.yaw_deg, (float)i + 2.0F, 0.0);
        }
        stream.bytes[bit / 8] ^= (uint8_t)(1U << (bit % 8));
    }
}

static void a_silent_line_gives_up_the_candidate_but_not_what_is_inside(void** state)
{
    (void)state;
    stream_t stream = {.size = 0};
    // header and type of the parameter frame, 84 bytes long, that never comes
    add_bytes(&stream, "\rQT,\x0B\x00\x00\x80", 8);
    add_ahrs(&stream, 5.0F);
    static line_t line;
    line_init(&line, &frame_from_board);
    line_feed(&line, stream.bytes, stream.size, 0);
    assert_int_equal(line.count, 0);
    assert_true(frame_decoder_is_waiting(&line.decoder));
    line_expire(&line);
    assert_int_equal(line.count, 1);
    assert_int_equal(line.decoder.damage[frame_damage_time_out], 1);
    assert_false(frame_decoder_is_waiting(&line.decoder));
    // and the line goes on as if nothing had been
    stream.size = 0;
    add_ahrs(&stream, 6.0F);
    line_feed(&line, stream.bytes, stream.size, 3);
    assert_int_equal(line.count, 2);
}

static void a_greeting_between_frames_is_seen_and_one_in_a_payload_is_not(void** state)
{
    (void)state;
    stream_t stream = {.size = 0};
    add_bytes(&stream, "#QT\n", 4);
    uint8_t payload[4];
    memcpy(payload, "#QT\n", 4);
    uint8_t frame[frame_max_bytes];
    add_bytes(&stream, frame,
              frame_encode(&frame_to_board, COMMAND_SET_K_ELEV_ID, payload, sizeof payload, frame, sizeof frame));
    for (size_t chunk = 0; chunk < 6; chunk++)
    {
        static line_t line;
        line_init(&line, &frame_to_board);
        line_feed(&line, stream.bytes, stream.size, chunk);
        assert_int_equal(line.greetings, 1);
        assert_int_equal(line.count, 1);
        assert_int_equal(line.decoder.noise_bytes, 0);
    }
}

static void received_and_refused_are_counted(void** state)
{
    (void)state;
    stream_t stream = {.size = 0};
    add_ahrs(&stream, 1.0F);
    add_ahrs(&stream, 2.0F);
    stream.bytes[10] ^= 0x10; // payload of the first
    static line_t line;
    line_init(&line, &frame_from_board);
    line_feed(&line, stream.bytes, stream.size, 7);
    assert_int_equal(line.decoder.received, 1);
    assert_int_equal(frame_decoder_rejected(&line.decoder), 1);
    assert_int_equal(line.decoder.damage[frame_damage_checksum], 1);
}

static void the_decoder_takes_no_more_than_it_has_room_for(void** state)
{
    (void)state;
    uint8_t bytes[3 * frame_buffer_bytes] = {0};
    frame_decoder_t decoder;
    frame_decoder_init(&decoder, &frame_from_board);
    assert_int_equal(frame_decoder_feed(&decoder, bytes, sizeof bytes), frame_buffer_bytes);
    assert_int_equal(frame_decoder_feed(&decoder, bytes, sizeof bytes), 0);
    frame_t frame;
    assert_int_equal(frame_decoder_next(&decoder, &frame), frame_event_none);
    assert_int_equal(frame_decoder_feed(&decoder, bytes, sizeof bytes), frame_buffer_bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_encoded_frame_has_the_bytes_of_a_captured_one),
        cmocka_unit_test(a_frame_that_does_not_fit_is_not_written),
        cmocka_unit_test(cut_points_do_not_matter),
        cmocka_unit_test(noise_never_hides_the_next_frame),
        cmocka_unit_test(every_single_flipped_bit_is_refused_and_costs_only_its_frame),
        cmocka_unit_test(a_silent_line_gives_up_the_candidate_but_not_what_is_inside),
        cmocka_unit_test(a_greeting_between_frames_is_seen_and_one_in_a_payload_is_not),
        cmocka_unit_test(received_and_refused_are_counted),
        cmocka_unit_test(the_decoder_takes_no_more_than_it_has_room_for),
    };
    return cmocka_run_group_tests_name("comms.frame", tests, NULL, NULL);
}

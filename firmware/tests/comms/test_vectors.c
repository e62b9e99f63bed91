#include "support/cmocka_all.h"

#include <string.h>

#include "comms/frame.h"
#include "flight/board_commands.h"
#include "support/line.h"
#include "vectors_gen.h"

#define LENGTH(array) (sizeof(array) / sizeof(array)[0])

enum
{
    captured_commands = 279
};

static void every_captured_use_of_the_station_is_understood(void** state)
{
    (void)state;
    assert_int_equal(LENGTH(command_vectors), captured_commands);
    for (size_t i = 0; i < LENGTH(command_vectors); i++)
    {
        const command_vector_t* const vector = &command_vectors[i];
        static line_t line;
        line_init(&line, &frame_to_board);
        line_feed(&line, vector->bytes, vector->size, 1 + i % 5);
        if (line.count != vector->commands || frame_decoder_rejected(&line.decoder) != 0)
        {
            fail_msg("%s: %zu commands, expected %zu", vector->name, line.count, vector->commands);
        }
    }
}

static void every_captured_command_encodes_to_its_own_bytes(void** state)
{
    (void)state;
    size_t compared = 0;
    for (size_t i = 0; i < LENGTH(command_vectors); i++)
    {
        const command_vector_t* const vector = &command_vectors[i];
        if (vector->commands != 1 || vector->size < frame_overhead_bytes)
        {
            continue;
        }
        static line_t line;
        line_init(&line, &frame_to_board);
        line_feed(&line, vector->bytes, vector->size, 0);
        uint8_t frame[frame_max_bytes];
        const size_t size = frame_encode(&frame_to_board, line.frames[0].type_id, line.frames[0].payload,
                                         line.frames[0].payload_size, frame, sizeof frame);
        assert_int_equal(size, vector->size);
        assert_memory_equal(frame, vector->bytes, size);
        compared++;
    }
    assert_true(compared > 200);
}

static void every_captured_command_has_its_row_in_the_boards_table(void** state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(command_vectors); i++)
    {
        static line_t line;
        line_init(&line, &frame_to_board);
        line_feed(&line, command_vectors[i].bytes, command_vectors[i].size, 0);
        for (size_t j = 0; j < line.count; j++)
        {
            size_t rows = 0;
            for (size_t k = 0; k < board_commands_count; k++)
            {
                rows += board_commands[k].type_id == line.frames[j].type_id &&
                                board_commands[k].payload_size == line.frames[j].payload_size
                            ? 1
                            : 0;
            }
            assert_int_equal(rows, 1);
        }
    }
}

static void every_telemetry_vector_is_accepted_or_refused_as_it_says(void** state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(telemetry_vectors); i++)
    {
        const telemetry_vector_t* const vector = &telemetry_vectors[i];
        // what a real line goes on with: something that ends the wait for a longer frame
        const uint8_t silence[frame_max_bytes] = {0};
        static line_t line;
        line_init(&line, &frame_from_board);
        line_feed(&line, vector->bytes, vector->size, 0);
        line_feed(&line, silence, sizeof silence, 0);
        if (line.count != (vector->refused < 0 ? 1U : 0U))
        {
            fail_msg("%s: %zu frames", vector->name, line.count);
        }
        if (vector->refused >= 0)
        {
            assert_int_equal(line.decoder.damage[vector->refused], 1);
        }
        assert_int_equal(frame_decoder_rejected(&line.decoder), vector->refused < 0 ? 0 : 1);
    }
}

static void check_stream(const stream_vector_t* vector, size_t chunk)
{
    static line_t line;
    line_init(&line, vector->dialect);
    line_feed(&line, vector->bytes, vector->size, chunk);
    if (line.count != vector->frame_count)
    {
        fail_msg("%s, chunks of %zu: %zu frames, expected %zu", vector->name, chunk, line.count, vector->frame_count);
    }
    for (size_t i = 0; i < line.count; i++)
    {
        assert_int_equal(line.frames[i].type_id, vector->frames[i].type_id);
        assert_int_equal(line.frames[i].payload_size, vector->frames[i].payload_size);
        assert_memory_equal(line.frames[i].payload, vector->frames[i].payload, vector->frames[i].payload_size);
    }
    assert_memory_equal(line.decoder.damage, vector->damage, sizeof vector->damage);
    const size_t dropped = line.decoder.noise_bytes + 4U * frame_decoder_rejected(&line.decoder) + 4U * line.greetings;
    assert_int_equal(dropped, vector->dropped_bytes);
}

static void every_damaged_stream_gives_its_frames_whatever_the_chunks(void** state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(stream_vectors); i++)
    {
        for (size_t chunk = 0; chunk <= stream_vectors[i].size; chunk++)
        {
            check_stream(&stream_vectors[i], chunk);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_captured_use_of_the_station_is_understood),
        cmocka_unit_test(every_captured_command_encodes_to_its_own_bytes),
        cmocka_unit_test(every_captured_command_has_its_row_in_the_boards_table),
        cmocka_unit_test(every_telemetry_vector_is_accepted_or_refused_as_it_says),
        cmocka_unit_test(every_damaged_stream_gives_its_frames_whatever_the_chunks),
    };
    return cmocka_run_group_tests_name("comms.vectors", tests, NULL, NULL);
}

#include "support/cmocka_all.h"

#include <stdlib.h>
#include <string.h>

#include "comms/frame.h"
#include "comms/protocol_gen.h"
#include "support/random.h"

enum
{
    frame_count = 100000,
    bytes_max = 6000000
};

/// One frame as it was sent.
typedef struct
{
    uint32_t type_id;
    size_t start;
    size_t size;
    bool intact;
} sent_t;

typedef struct
{
    uint8_t* bytes;   ///< damaged
    uint8_t* sent_as; ///< before the damage
    size_t size;
    sent_t* frames;
    size_t intact;
} recording_t;

/// What one run of the decoder found.
typedef struct
{
    size_t intact; ///< of the frames that were not damaged, found in order
    size_t wrong;  ///< accepted, but none of them
    uint32_t rejected;
    uint32_t digest; ///< of all accepted frames
} result_t;

static const uint32_t telemetry_ids[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0x100, 0x101, 0x102, 0x103, 0x104};

static void make_recording(recording_t* recording)
{
    uint32_t seed = 20260101;
    for (size_t i = 0; i < frame_count; i++)
    {
        const uint32_t type_id = telemetry_ids[random_below(&seed, sizeof telemetry_ids / sizeof telemetry_ids[0])];
        const size_t payload_size = (size_t)protocol_telemetry_size(type_id);
        uint8_t payload[frame_payload_max_bytes];
        for (size_t j = 0; j < payload_size; j++)
        {
            payload[j] = (uint8_t)random_below(&seed, 256);
        }
        sent_t* const sent = &recording->frames[i];
        *sent = (sent_t){.type_id = type_id, .start = recording->size, .intact = true};
        sent->size = frame_encode(&frame_from_board, type_id, payload, payload_size, recording->bytes + recording->size,
                                  bytes_max - recording->size);
        assert_true(sent->size > 0);
        recording->size += sent->size;
    }
    memcpy(recording->sent_as, recording->bytes, recording->size);
    size_t frame = 0;
    for (size_t i = 0; i < recording->size; i++)
    {
        while (i >= recording->frames[frame].start + recording->frames[frame].size)
        {
            frame++;
        }
        if (random_below(&seed, 1000) == 0)
        {
            recording->bytes[i] ^= (uint8_t)(1U << random_below(&seed, 8));
            recording->frames[frame].intact = false;
        }
    }
    for (size_t i = 0; i < frame_count; i++)
    {
        recording->intact += recording->frames[i].intact ? 1 : 0;
    }
}

static int set_up(void** state)
{
    recording_t* const recording = calloc(1, sizeof *recording);
    recording->bytes = calloc(1, bytes_max);
    recording->sent_as = calloc(1, bytes_max);
    recording->frames = calloc(frame_count, sizeof *recording->frames);
    make_recording(recording);
    *state = recording;
    return 0;
}

static int tear_down(void** state)
{
    recording_t* const recording = *state;
    free(recording->bytes);
    free(recording->sent_as);
    free(recording->frames);
    free(recording);
    return 0;
}

static bool is_as_sent(const recording_t* recording, const sent_t* sent, const frame_t* frame)
{
    return sent->type_id == frame->type_id && sent->size == frame->payload_size + frame_overhead_bytes &&
           memcmp(recording->sent_as + sent->start + 8, frame->payload, frame->payload_size) == 0;
}

/// Match one accepted frame with the next undamaged ones.
static void judge(const recording_t* recording, const frame_t* frame, size_t* next, result_t* result)
{
    for (size_t i = 0; i < frame->payload_size; i++)
    {
        result->digest = (result->digest ^ frame->payload[i]) * 16777619U;
    }
    result->digest = (result->digest ^ frame->type_id) * 16777619U;
    while (*next < frame_count && !recording->frames[*next].intact)
    {
        (*next)++;
    }
    if (*next < frame_count && is_as_sent(recording, &recording->frames[*next], frame))
    {
        (*next)++;
        result->intact++;
        return;
    }
    result->wrong++;
}

static result_t decode(const recording_t* recording, size_t chunk)
{
    result_t result = {.digest = 2166136261U};
    frame_decoder_t decoder;
    frame_decoder_init(&decoder, &frame_from_board);
    size_t next = 0;
    size_t position = 0;
    while (position < recording->size)
    {
        size_t left = recording->size - position < chunk ? recording->size - position : chunk;
        while (left > 0)
        {
            const size_t taken = frame_decoder_feed(&decoder, recording->bytes + position, left);
            position += taken;
            left -= taken;
            frame_t frame;
            while (frame_decoder_next(&decoder, &frame) == frame_event_frame)
            {
                judge(recording, &frame, &next, &result);
            }
        }
    }
    result.rejected = frame_decoder_rejected(&decoder);
    return result;
}

static void no_intact_frame_is_lost_and_the_chunks_make_no_difference(void** state)
{
    const recording_t* const recording = *state;
    // 0.1 % of the bytes: some four of a hundred frames are hit
    assert_in_range(recording->intact, frame_count * 94 / 100, frame_count * 98 / 100);
    const size_t chunks[] = {1, 2, 3, 8, 64, 4096};
    const result_t first = decode(recording, chunks[0]);
    for (size_t i = 0; i < sizeof chunks / sizeof chunks[0]; i++)
    {
        const result_t result = decode(recording, chunks[i]);
        assert_int_equal(result.intact, recording->intact);
        assert_int_equal(result.digest, first.digest);
        assert_int_equal(result.rejected, first.rejected);
        // two flips in one frame that cancel out in the sum: the checksum's own limit, some in a million
        assert_in_range(result.wrong, 0, 20);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(no_intact_frame_is_lost_and_the_chunks_make_no_difference, set_up, tear_down),
    };
    return cmocka_run_group_tests_name("comms.damaged_stream", tests, NULL, NULL);
}

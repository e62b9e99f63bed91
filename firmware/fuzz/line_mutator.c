// How inputs are changed: libFuzzer changes bytes, whole frames are moved, and then most frames get a correct checksum
// and end marker again. Otherwise hardly any input would pass the checksum and test the code after it.
#include "fuzz.h"

#include <string.h>

#include "comms/protocol_gen.h"
#include "support/random.h"

typedef struct
{
    uint8_t* bytes;
    size_t size;
    size_t capacity;
} line_bytes_t;

typedef struct
{
    size_t at;
    size_t size; ///< 0: no frame found
} piece_t;

/// Values that often break programs: limits, limits plus or minus one, NaN and infinity.
static const uint32_t words[] = {
    0U,          1U,          2U,          19U,         20U,         99U,         100U,        101U,
    0xFFFFFFFFU, 0x7FFFFFFFU, 0x80000000U, 0x3F800000U, 0xBF800000U, 0x3F800001U, 0x7F800000U, 0xFF800000U,
    0x7FC00000U, 0x00000001U, 0x7F7FFFFFU, 0x42B40000U, 0x43340000U, 0x476A6000U, 0xC4FA0000U, 0x43FA0000U,
};

static const uint32_t types[] = {
    COMMAND_XPLANE_INFO_ID,    COMMAND_MISSION_BEGIN_ID,           COMMAND_MISSION_ITEM_ID,
    COMMAND_MISSION_ITEM_ID,   COMMAND_MISSION_COMMIT_ID,          COMMAND_MISSION_COMMIT_ID,
    COMMAND_MISSION_READ_ID,   COMMAND_GO_TO_WAYPOINT_ID,          COMMAND_SERVO_OUT_ID,
    COMMAND_CONTROL_SOURCE_ID, COMMAND_SET_PARAMETER_TASK_RATE_ID, COMMAND_STORE_PARAMETERS_ID,
};

static const frame_dialect_t* dialect_at(const line_bytes_t* line, size_t at)
{
    const frame_dialect_t* const dialects[] = {&frame_to_board, &frame_from_board};
    for (size_t i = 0; i < sizeof dialects / sizeof dialects[0]; i++)
    {
        if (line->size - at >= 8U && protocol_get_u32(line->bytes + at) == dialects[i]->header)
        {
            return dialects[i];
        }
    }
    return NULL;
}

/// The first frame from `at` on, good or damaged.
static piece_t frame_from(const line_bytes_t* line, size_t at)
{
    for (size_t i = at; i + frame_overhead_bytes <= line->size; i++)
    {
        const frame_dialect_t* const dialect = dialect_at(line, i);
        if (dialect == NULL)
        {
            continue;
        }
        const uint32_t type = protocol_get_u32(line->bytes + i + 4U) & ~dialect->type_flags;
        const int32_t payload_size = dialect->payload_size(type);
        const size_t size = frame_overhead_bytes + (payload_size > 0 ? (size_t)payload_size : 0U);
        if (i + size <= line->size)
        {
            return (piece_t){i, size};
        }
    }
    return (piece_t){0U, 0U};
}

/// A random one of the frames.
static piece_t some_frame(const line_bytes_t* line, uint32_t* random)
{
    const size_t from = random_below(random, (uint32_t)line->size + 1U);
    const piece_t found = frame_from(line, from);
    return found.size > 0U ? found : frame_from(line, 0U);
}

/// Give every frame its correct checksum and end marker.
static void repair(line_bytes_t* line)
{
    for (piece_t frame = frame_from(line, 0U); frame.size > 0U; frame = frame_from(line, frame.at + frame.size))
    {
        uint8_t* const bytes = line->bytes + frame.at;
        uint32_t sum = 0U;
        for (size_t i = 4U; i < frame.size - 8U; i += 4U)
        {
            sum += protocol_get_u32(bytes + i);
        }
        protocol_put_u32(bytes + frame.size - 8U, 0U - sum);
        protocol_put_u32(bytes + frame.size - 4U, PROTOCOL_END);
    }
}

static void insert(line_bytes_t* line, size_t at, const uint8_t* bytes, size_t size)
{
    if (line->size + size <= line->capacity)
    {
        memmove(line->bytes + at + size, line->bytes + at, line->size - at);
        memcpy(line->bytes + at, bytes, size);
        line->size += size;
    }
}

static void repeat_frame(line_bytes_t* line, uint32_t* random)
{
    const piece_t frame = some_frame(line, random);
    uint8_t copy[frame_max_bytes];
    if (frame.size > 0U && frame.size <= sizeof copy)
    {
        memcpy(copy, line->bytes + frame.at, frame.size);
        const piece_t before = some_frame(line, random);
        insert(line, before.at, copy, frame.size);
    }
}

static void remove_frame(line_bytes_t* line, uint32_t* random)
{
    const piece_t frame = some_frame(line, random);
    const size_t behind = frame.at + frame.size;
    memmove(line->bytes + frame.at, line->bytes + behind, line->size - behind);
    line->size -= frame.size;
}

/// Replace a word of the payload, or the lowest byte of one, by a value of the table.
static void change_word(line_bytes_t* line, uint32_t* random)
{
    const piece_t frame = some_frame(line, random);
    if (frame.size > frame_overhead_bytes)
    {
        const uint32_t count = (uint32_t)(frame.size - frame_overhead_bytes) / 4U;
        uint8_t* const word = line->bytes + frame.at + 8U + 4U * (size_t)random_below(random, count);
        protocol_put_u32(word, words[random_below(random, sizeof words / sizeof words[0])]);
    }
}

static void add_frame(line_bytes_t* line, uint32_t* random)
{
    uint8_t payload[frame_payload_max_bytes] = {0};
    uint8_t frame[frame_max_bytes];
    const uint32_t type = types[random_below(random, sizeof types / sizeof types[0])];
    const size_t size = (size_t)frame_to_board.payload_size(type);
    for (size_t i = 0; i + 4U <= size; i += 4U)
    {
        protocol_put_u32(payload + i, words[random_below(random, 8U)]);
    }
    const size_t length = frame_encode(&frame_to_board, type, payload, size, frame, sizeof frame);
    const piece_t before = some_frame(line, random);
    insert(line, before.at, frame, length);
}

static void mutate_bytes(line_bytes_t* line, uint32_t* random)
{
    (void)random;
    line->size = LLVMFuzzerMutate(line->bytes, line->size, line->capacity);
}

size_t LLVMFuzzerCustomMutator(uint8_t* bytes, size_t size, size_t capacity, unsigned int seed)
{
    static void (*const changes[])(line_bytes_t*, uint32_t*) = {
        mutate_bytes, mutate_bytes, mutate_bytes, repeat_frame, remove_frame, change_word, change_word, add_frame,
    };
    uint32_t random = seed * 2654435761U + 1U;
    random = random == 0U ? 1U : random;
    // sometimes change the choices too
    if (size <= fuzz_choices_bytes || capacity <= fuzz_choices_bytes || random_below(&random, 16U) == 0U)
    {
        return LLVMFuzzerMutate(bytes, size, capacity);
    }
    line_bytes_t line = {bytes + fuzz_choices_bytes, size - fuzz_choices_bytes, capacity - fuzz_choices_bytes};
    changes[random_below(&random, sizeof changes / sizeof changes[0])](&line, &random);
    if (random_below(&random, 8U) != 0U)
    {
        repair(&line);
    }
    return fuzz_choices_bytes + line.size;
}

#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>

#include "comms/protocol_gen.h"
#include "flight/board.h"
#include "support/random.h"

bool fuzz_read_input(fuzz_input_t* input, const uint8_t* bytes, size_t size)
{
    if (size < fuzz_choices_bytes)
    {
        return false;
    }
    const uint32_t flags = protocol_get_u32(bytes);
    *input = (fuzz_input_t){
        .flags = flags,
        .random = flags == 0U ? 1U : flags,
        .line = bytes + fuzz_choices_bytes,
        .line_size = size - fuzz_choices_bytes,
    };
    return true;
}

void fuzz_require(bool holds, const char* sentence)
{
    if (!holds)
    {
        (void)fprintf(stderr, "finding: not so: %s\n", sentence);
        abort();
    }
}

size_t fuzz_piece(fuzz_input_t* input, size_t left)
{
    static const size_t most[] = {1, 32, 128, 128, 512};
    const size_t limit = most[random_below(&input->random, sizeof most / sizeof most[0])];
    const size_t size = 1U + random_below(&input->random, (uint32_t)limit);
    return size < left ? size : left;
}

const frame_dialect_t* fuzz_dialect(uint32_t flags)
{
    static const frame_dialect_t* const dialects[] = {&board_frames_in, &frame_from_board, &frame_to_board};
    return dialects[flags % (sizeof dialects / sizeof dialects[0])];
}

/// What the fuzz targets share: a finding, random choices, and the input's layout.
///
/// An input is `fuzz_choices_bytes` of choices, from which time, sensors and the size of pieces follow, and then bytes
/// as they come on the line, so that a recording of a line is a seed as it is.
#ifndef FUZZ_H
#define FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "comms/frame.h"

enum
{
    fuzz_choices_bytes = 4
};

/// The choices of an input and the line's bytes behind them.
typedef struct
{
    uint32_t flags;  ///< the first word as it stands
    uint32_t random; ///< for `random_next`, from the same word; never 0
    const uint8_t* line;
    size_t line_size;
} fuzz_input_t;

/// False when the input is too short to be one.
bool fuzz_read_input(fuzz_input_t* input, const uint8_t* bytes, size_t size);

/// A property of the program: where it does not hold, the sentence is printed and the fuzzer has its finding.
void fuzz_require(bool holds, const char* sentence);

/// How many of the `left` bytes come in at once: mostly a few, sometimes as many as the line's ring holds.
size_t fuzz_piece(fuzz_input_t* input, size_t left);

/// The dialects in the order in which `flags` choose them.
const frame_dialect_t* fuzz_dialect(uint32_t flags);

// libFuzzer finds these two by name; a fuzz target has the first, line_mutator.c the second.
int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size);
size_t LLVMFuzzerCustomMutator(uint8_t* bytes, size_t size, size_t capacity, unsigned int seed);

/// libFuzzer's own: change the bytes somehow and return their new number.
size_t LLVMFuzzerMutate(uint8_t* bytes, size_t size, size_t capacity);

#endif

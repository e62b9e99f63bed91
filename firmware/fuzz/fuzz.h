/// What the fuzz targets share: reporting a finding, random choices, and the layout of an input.
///
/// An input starts with `fuzz_choices_bytes` of choices, which decide times, sensor readings and the sizes of pieces.
/// The bytes of the line follow, so that a recorded line behind any choices is a seed.
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

/// The choices of an input, and the bytes of the line that follow them.
typedef struct
{
    uint32_t flags;  ///< the first word, unchanged
    uint32_t random; ///< state for `random_next`, made from the same word; never 0
    const uint8_t* line;
    size_t line_size;
} fuzz_input_t;

/// False when the input is too short.
bool fuzz_read_input(fuzz_input_t* input, const uint8_t* bytes, size_t size);

/// Check a property of the program. If it does not hold, print the sentence and abort, which is a finding for the
/// fuzzer.
void fuzz_require(bool holds, const char* sentence);

/// How many of the `left` bytes to give at once: mostly a few, sometimes as many as the line's ring holds.
size_t fuzz_piece(fuzz_input_t* input, size_t left);

/// The dialects in the order in which `flags` choose them.
const frame_dialect_t* fuzz_dialect(uint32_t flags);

// libFuzzer finds these two by name; a fuzz target has the first, line_mutator.c the second.
int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size);
size_t LLVMFuzzerCustomMutator(uint8_t* bytes, size_t size, size_t capacity, unsigned int seed);

/// libFuzzer's own mutation: change the bytes and return their new number.
size_t LLVMFuzzerMutate(uint8_t* bytes, size_t size, size_t capacity);

#endif

/// Small deterministic random numbers (xorshift32), so that a failing test fails again.
#ifndef SUPPORT_RANDOM_H
#define SUPPORT_RANDOM_H

#include <stdint.h>

/// The next number; `state` must not be 0.
static inline uint32_t random_next(uint32_t* state)
{
    uint32_t x = *state;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    *state = x;
    return x;
}

/// 0..limit-1.
static inline uint32_t random_below(uint32_t* state, uint32_t limit)
{
    return random_next(state) % limit;
}

#endif

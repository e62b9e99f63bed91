/// The processor's first steps: vector table, memory, floating-point unit, then `main`.
#ifndef STARTUP_H
#define STARTUP_H

#include <stdint.h>

/// Handler of every interrupt that has no other: a fault of the program. Restarts the board.
void startup_fault(void);

/// One entry of the vector table: the core's own 16, then the machine's interrupts in the hardware's order (in section
/// `.vectors.machine`). The first entry is the initial stack pointer.
typedef union
{
    void (*handler)(void);
    const void* stack;
} startup_vector_t;

#endif

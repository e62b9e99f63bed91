/// The parts of a processor that the kernel's POSIX port leaves out: an accurate tick, a run-time counter and
/// interrupts.
///
/// Tasks are threads of which one runs at a time; an interrupt is a signal to the whole process. Every thread except
/// the running task blocks all signals. So the PC delivers the signal to the running task, at once or when that leaves
/// its critical section, as an interrupt would be. Device threads must therefore block all signals.
#ifndef KERNEL_H
#define KERNEL_H

#include <stdbool.h>

typedef enum
{
    kernel_interrupt_uart,
    kernel_interrupt_card,
    kernel_interrupt_count
} kernel_interrupt_t;

/// Block every signal in this thread (and in those it starts), and make SIGUSR2 the interrupt. Call it first.
void kernel_init(void);

/// Let `handler` serve an interrupt. It runs in interrupt context and may only call the kernel's ...FromISR functions.
/// It returns true when it woke a task that should run now.
void kernel_serve(kernel_interrupt_t interrupt, bool (*handler)(void));

/// Raise an interrupt from a device thread. Raised twice before it is served, it is served only once.
void kernel_raise(kernel_interrupt_t interrupt);

#endif

/// Waiting for a device.
#ifndef PAUSE_H
#define PAUSE_H

/// Wait for at least one millisecond; other tasks run meanwhile, once the kernel runs. Has the form of `spi_t.pause`,
/// therefore `unused`.
void pause_a_millisecond(void* unused);

#endif

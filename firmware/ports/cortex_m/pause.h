/// Waiting for a device.
#ifndef PAUSE_H
#define PAUSE_H

/// Let one millisecond pass at least, in which other tasks run once there are any. `unused` makes it a `spi_t.pause`.
void pause_a_millisecond(void* unused);

#endif

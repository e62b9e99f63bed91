/// Arm's semihosting: calls that an emulator answers. On a processor without a debugger such a call is a fault.
#ifndef SEMIHOSTING_H
#define SEMIHOSTING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Operations and open modes of "Semihosting for AArch32 and AArch64".
enum
{
    semihosting_open = 0x01,
    semihosting_close = 0x02,
    semihosting_write = 0x05,
    semihosting_read = 0x06,
    semihosting_seek = 0x0A,
    semihosting_length = 0x0C,
    semihosting_remove = 0x0E,
    semihosting_command_line = 0x15,
    semihosting_mode_read = 1,   ///< an existing file, to read
    semihosting_mode_change = 3, ///< an existing file, to read and write
    semihosting_mode_make = 7,   ///< a new, empty file
    semihosting_path_bytes = 288
};

/// One operation; the emulator stands still until it is done.
int32_t semihosting_ask(uint32_t operation, const uint32_t* arguments);

/// An address as an argument.
uint32_t semihosting_address(const void* object);

/// Handle of the opened file, negative when it cannot be opened.
int32_t semihosting_open_file(const char* path, uint32_t mode);

/// Read or write all of `size` bytes of an open file.
bool semihosting_move(uint32_t operation, int32_t file, const void* data, size_t size);

/// An operation whose only argument is an open file: ask its length, or close it.
int32_t semihosting_of(uint32_t operation, int32_t file);

#endif

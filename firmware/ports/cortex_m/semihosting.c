#include "semihosting.h"

#include <string.h>

int32_t semihosting_ask(uint32_t operation, const uint32_t* arguments)
{
    register uint32_t in_and_out __asm("r0") = operation;
    register const uint32_t* const block __asm("r1") = arguments;
    __asm volatile("bkpt 0xAB" : "+r"(in_and_out) : "r"(block) : "memory");
    return (int32_t)in_and_out;
}

uint32_t semihosting_address(const void* object)
{
    return (uint32_t)(uintptr_t)object;
}

int32_t semihosting_open_file(const char* path, uint32_t mode)
{
    const uint32_t arguments[] = {semihosting_address(path), mode, (uint32_t)strlen(path)};
    return semihosting_ask(semihosting_open, arguments);
}

bool semihosting_move(uint32_t operation, int32_t file, const void* data, size_t size)
{
    // the answer is the number of bytes that were not transferred
    const uint32_t arguments[] = {(uint32_t)file, semihosting_address(data), (uint32_t)size};
    return semihosting_ask(operation, arguments) == 0;
}

int32_t semihosting_of(uint32_t operation, int32_t file)
{
    const uint32_t arguments[] = {(uint32_t)file};
    return semihosting_ask(operation, arguments);
}

/// Registers of the Cortex-M4 core itself (ARMv7-M Architecture Reference Manual, B3), only those in use.
#ifndef CORE_H
#define CORE_H

#include <stdint.h>

#define CORE_REGISTER(address) (*(volatile uint32_t*)(address))

// SysTick: counts down from RELOAD to 0 once each tick.
#define CORE_SYSTICK_RELOAD CORE_REGISTER(0xE000E014U)
#define CORE_SYSTICK_VALUE CORE_REGISTER(0xE000E018U)

// Interrupt controller: one bit, or one byte of priority, for each interrupt.
#define CORE_INTERRUPT_ENABLE(number) CORE_REGISTER(0xE000E100U + 4U * ((number) / 32U))
#define CORE_INTERRUPT_PEND(number) CORE_REGISTER(0xE000E200U + 4U * ((number) / 32U))
#define CORE_INTERRUPT_PRIORITY(number) (*(volatile uint8_t*)(0xE000E400U + (number)))
#define CORE_INTERRUPT_BIT(number) (1U << ((number) % 32U))

// System control block.
#define CORE_INTERRUPT_STATE CORE_REGISTER(0xE000ED04U)
#define CORE_INTERRUPT_STATE_TICK_PENDS (1U << 26U)
#define CORE_VECTOR_TABLE CORE_REGISTER(0xE000ED08U)
#define CORE_RESET_CONTROL CORE_REGISTER(0xE000ED0CU)
#define CORE_RESET_CONTROL_RESET 0x05FA0004U ///< the key that allows the write, and the request
#define CORE_COPROCESSORS CORE_REGISTER(0xE000ED88U)
#define CORE_COPROCESSORS_FPU (0xFU << 20U) ///< full access to coprocessors 10 and 11

/// Wait until all earlier writes have taken effect.
static inline void core_barrier(void)
{
    __asm volatile("dsb\n\tisb" ::: "memory");
}

/// Enable interrupt `number`, at a priority that may call the kernel.
static inline void core_interrupt_enable(uint32_t number)
{
    CORE_INTERRUPT_PRIORITY(number) = 0x60U;
    CORE_INTERRUPT_ENABLE(number) = CORE_INTERRUPT_BIT(number);
}

/// Raise interrupt `number` by software.
static inline void core_interrupt_pend(uint32_t number)
{
    CORE_INTERRUPT_PEND(number) = CORE_INTERRUPT_BIT(number);
    core_barrier();
}

#endif

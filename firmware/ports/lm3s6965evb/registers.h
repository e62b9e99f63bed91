/// Registers of the LM3S6965 (data sheet) and of Arm's PrimeCells in it (PL011, PL022, PL061), only those in use.
#ifndef REGISTERS_H
#define REGISTERS_H

#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))

// Clock gates: of the serial ports and the bus, and of the pins.
#define SYSCTL_RCGC1 REGISTER(0x400FE104U)
#define SYSCTL_RCGC1_UART0 (1U << 0U)
#define SYSCTL_RCGC1_SSI0 (1U << 4U)
#define SYSCTL_RCGC2 REGISTER(0x400FE108U)
#define SYSCTL_RCGC2_GPIOD (1U << 3U)

// First serial port (PL011).
#define UART0_DR REGISTER(0x4000C000U)
#define UART0_FR REGISTER(0x4000C018U)
#define UART0_FR_RECEIVER_EMPTY (1U << 4U)
#define UART0_FR_TRANSMITTER_FULL (1U << 5U)
#define UART0_IBRD REGISTER(0x4000C024U)
#define UART0_FBRD REGISTER(0x4000C028U)
#define UART0_LCRH REGISTER(0x4000C02CU)
#define UART0_LCRH_8_BITS (3U << 5U)
#define UART0_CTL REGISTER(0x4000C030U)
#define UART0_CTL_ON 0x301U ///< port, transmitter, receiver
#define UART0_IM REGISTER(0x4000C038U)
#define UART0_IM_RECEIVE (1U << 4U)
#define UART0_IM_TRANSMIT (1U << 5U)
#define UART0_ICR REGISTER(0x4000C044U)
#define UART0_INTERRUPT 5U

// Port D (PL061): pin 0 selects the card. The address selects the pins that are written.
#define GPIOD_DATA_PIN_0 REGISTER(0x40007004U)
#define GPIOD_DIR REGISTER(0x40007400U)
#define GPIOD_DEN REGISTER(0x4000751CU)

// Synchronous serial interface (PL022).
#define SSI0_CR0 REGISTER(0x40008000U)
#define SSI0_CR0_8_BITS 7U
#define SSI0_CR1 REGISTER(0x40008004U)
#define SSI0_CR1_ENABLE (1U << 1U)
#define SSI0_DR REGISTER(0x40008008U)
#define SSI0_SR REGISTER(0x4000800CU)
#define SSI0_SR_TRANSMITTER_TAKES (1U << 1U)
#define SSI0_SR_RECEIVER_HOLDS (1U << 2U)
#define SSI0_CPSR REGISTER(0x40008010U)

#endif

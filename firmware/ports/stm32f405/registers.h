/// Registers of the STM32F405 (reference manual RM0090), only those in use.
#ifndef REGISTERS_H
#define REGISTERS_H

#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))

// Reset and clock control.
#define RCC_CR REGISTER(0x40023800U)
#define RCC_CR_HSIRDY (1U << 1U)
#define RCC_CR_HSEON (1U << 16U)
#define RCC_CR_HSERDY (1U << 17U)
#define RCC_CR_PLLON (1U << 24U)
#define RCC_CR_PLLRDY (1U << 25U)
#define RCC_PLLCFGR REGISTER(0x40023804U)
#define RCC_PLLCFGR_N_336 (336U << 6U)
#define RCC_PLLCFGR_SOURCE_HSE (1U << 22U)
#define RCC_PLLCFGR_Q_7 (7U << 24U)
#define RCC_CFGR REGISTER(0x40023808U)
#define RCC_CFGR_SW_PLL 2U
#define RCC_CFGR_SWS (3U << 2U)
#define RCC_CFGR_SWS_PLL (2U << 2U)
#define RCC_CFGR_APB1_QUARTER (5U << 10U)
#define RCC_CFGR_APB2_HALF (4U << 13U)
#define RCC_AHB1ENR REGISTER(0x40023830U)
#define RCC_AHB1ENR_GPIOA (1U << 0U)
#define RCC_AHB1ENR_GPIOB (1U << 1U)
#define RCC_APB1ENR REGISTER(0x40023840U)
#define RCC_APB1ENR_SPI2 (1U << 14U)
#define RCC_APB2ENR REGISTER(0x40023844U)
#define RCC_APB2ENR_USART1 (1U << 4U)

// Flash interface.
#define FLASH_ACR REGISTER(0x40023C00U)
#define FLASH_ACR_5_WAIT_STATES 5U
#define FLASH_ACR_CACHES (7U << 8U) ///< prefetch, instructions, data

// Port A; pins 9 and 10 are the first serial port's.
#define GPIOA_MODER REGISTER(0x40020000U)
#define GPIOA_PUPDR REGISTER(0x4002000CU)
#define GPIOA_AFRH REGISTER(0x40020024U)

// Port B; pins 12 to 15 are the card's.
#define GPIOB_MODER REGISTER(0x40020400U)
#define GPIOB_OSPEEDR REGISTER(0x40020408U)
#define GPIOB_PUPDR REGISTER(0x4002040CU)
#define GPIOB_BSRR REGISTER(0x40020418U)
#define GPIOB_AFRH REGISTER(0x40020424U)
#define GPIO_BSRR_SET(pin) (1U << (pin))
#define GPIO_BSRR_CLEAR(pin) (1U << ((pin) + 16U))
#define CARD_SELECT_PIN 12U

// Second serial peripheral interface.
#define SPI2_CR1 REGISTER(0x40003800U)
#define SPI2_CR1_MASTER (1U << 2U)
#define SPI2_CR1_DIVIDER_SHIFT 3U
#define SPI2_CR1_DIVIDER_MAX 7U
#define SPI2_CR1_ENABLE (1U << 6U)
#define SPI2_CR1_SOFTWARE_SELECT (3U << 8U) ///< the select pin is not used: always the master
#define SPI2_SR REGISTER(0x40003808U)
#define SPI2_SR_RXNE (1U << 0U)
#define SPI2_SR_TXE (1U << 1U)
#define SPI2_SR_BUSY (1U << 7U)
#define SPI2_DR REGISTER(0x4000380CU)

// First serial port.
#define USART1_SR REGISTER(0x40011000U)
#define USART1_SR_RXNE (1U << 5U)
#define USART1_SR_TXE (1U << 7U)
#define USART1_DR REGISTER(0x40011004U)
#define USART1_BRR REGISTER(0x40011008U)
#define USART1_CR1 REGISTER(0x4001100CU)
#define USART1_CR1_RE (1U << 2U)
#define USART1_CR1_TE (1U << 3U)
#define USART1_CR1_RXNEIE (1U << 5U)
#define USART1_CR1_TXEIE (1U << 7U)
#define USART1_CR1_UE (1U << 13U)
#define USART1_INTERRUPT 37U

// Independent watchdog, on its own 32 kHz (17 to 47) oscillator.
#define IWDG_KR REGISTER(0x40003000U)
#define IWDG_KR_FEED 0xAAAAU
#define IWDG_KR_UNLOCK 0x5555U
#define IWDG_KR_START 0xCCCCU
#define IWDG_PR REGISTER(0x40003004U)
#define IWDG_PR_32 3U
#define IWDG_RLR REGISTER(0x40003008U)

#endif

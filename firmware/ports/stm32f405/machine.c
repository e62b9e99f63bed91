#include "machine.h"

#include "core.h"
#include "machine_clock.h"
#include "registers.h"
#include "startup.h"
#include "uart_line.h"

static const uint32_t fast_hz = 168000000U;
static const uint32_t oscillator_hz = 16000000U; ///< the internal oscillator, in use after a reset
static const uint32_t crystal_mhz = 8U;
static const uint32_t internal_mhz = 16U;
static const uint32_t baud = 115200U;

enum
{
    ready_polls = 100000, ///< some 10 ms on the internal oscillator; a crystal needs 2
    vector_count = 82
};

uint32_t machine_clock_hz;
uint32_t machine_fast_bus_hz;
uint32_t machine_slow_bus_hz;

static void serve_uart(void)
{
    uart_line_interrupt();
}

/// An unused interrupt was never enabled, so its arrival is a fault.
#define UNUSED {.handler = startup_fault}
#define UNUSED_4 UNUSED, UNUSED, UNUSED, UNUSED
#define UNUSED_16 UNUSED_4, UNUSED_4, UNUSED_4, UNUSED_4

__attribute__((section(".vectors.machine"), used)) static const startup_vector_t vectors[vector_count] = {
    UNUSED_16, UNUSED_16, UNUSED_4, UNUSED,   {.handler = serve_uart}, // 37
    UNUSED_16, UNUSED_16, UNUSED_4, UNUSED_4, UNUSED_4,
};

/// Wait until `bits` of a register are set; false after too many polls.
static bool becomes(const volatile uint32_t* status, uint32_t mask, uint32_t wanted)
{
    for (uint32_t i = 0; i < ready_polls; i++)
    {
        if ((*status & mask) == wanted)
        {
            return true;
        }
    }
    return false;
}

/// 168 MHz from the crystal, or from the internal oscillator (1 % off, good enough for the line) where that does not
/// start; 16 MHz where the multiplier does not lock.
static void start_clock(void)
{
    machine_clock_hz = fast_hz;
    machine_fast_bus_hz = fast_hz / 2U;
    machine_slow_bus_hz = fast_hz / 4U;
    if ((RCC_CR & RCC_CR_HSIRDY) == 0U)
    {
        return; // no oscillator is ready, so the processor is emulated, and always fast
    }
    RCC_CR |= RCC_CR_HSEON;
    const bool has_crystal = becomes(&RCC_CR, RCC_CR_HSERDY, RCC_CR_HSERDY);
    RCC_PLLCFGR =
        (has_crystal ? crystal_mhz | RCC_PLLCFGR_SOURCE_HSE : internal_mhz) | RCC_PLLCFGR_N_336 | RCC_PLLCFGR_Q_7;
    RCC_CR |= RCC_CR_PLLON;
    if (becomes(&RCC_CR, RCC_CR_PLLRDY, RCC_CR_PLLRDY))
    {
        FLASH_ACR = FLASH_ACR_CACHES | FLASH_ACR_5_WAIT_STATES;
        RCC_CFGR = RCC_CFGR_APB1_QUARTER | RCC_CFGR_APB2_HALF;
        RCC_CFGR |= RCC_CFGR_SW_PLL;
        if (becomes(&RCC_CFGR, RCC_CFGR_SWS, RCC_CFGR_SWS_PLL))
        {
            return;
        }
    }
    RCC_CFGR = 0U;
    machine_clock_hz = oscillator_hz;
    machine_fast_bus_hz = oscillator_hz;
    machine_slow_bus_hz = oscillator_hz;
}

static void start_uart(void)
{
    RCC_AHB1ENR |= RCC_AHB1ENR_GPIOA;
    RCC_APB2ENR |= RCC_APB2ENR_USART1;
    core_barrier(); // a peripheral can be used two cycles after its clock is on
    // Pins 9 (out) and 10 (in) to their function 7. Pin 10 is pulled up, so that a cut wire reads as an idle line.
    GPIOA_AFRH = (GPIOA_AFRH & ~(0xFFU << 4U)) | (0x77U << 4U);
    GPIOA_PUPDR = (GPIOA_PUPDR & ~(3U << 20U)) | (1U << 20U);
    GPIOA_MODER = (GPIOA_MODER & ~(0xFU << 18U)) | (0xAU << 18U);
    USART1_BRR = (machine_fast_bus_hz + baud / 2U) / baud;
    USART1_CR1 = USART1_CR1_UE | USART1_CR1_TE | USART1_CR1_RE | USART1_CR1_RXNEIE;
}

void machine_start(void)
{
    start_clock();
    start_uart();
}

void machine_uart_enable(void)
{
    core_interrupt_enable(USART1_INTERRUPT);
}

bool machine_uart_receive(uint8_t* byte)
{
    if ((USART1_SR & USART1_SR_RXNE) == 0U)
    {
        return false;
    }
    // Reading status, then data, also clears an overrun.
    *byte = (uint8_t)USART1_DR;
    return true;
}

void machine_uart_watch_receiver(bool on)
{
    USART1_CR1 = on ? USART1_CR1 | USART1_CR1_RXNEIE : USART1_CR1 & ~USART1_CR1_RXNEIE;
}

bool machine_uart_transmit(uint8_t byte)
{
    if ((USART1_SR & USART1_SR_TXE) == 0U)
    {
        return false;
    }
    USART1_DR = byte;
    return true;
}

void machine_uart_watch_transmitter(bool on)
{
    if (on)
    {
        USART1_CR1 |= USART1_CR1_TXEIE;
        core_interrupt_pend(USART1_INTERRUPT);
    }
    else
    {
        USART1_CR1 &= ~USART1_CR1_TXEIE;
    }
}

void machine_watchdog_start(void)
{
    IWDG_KR = IWDG_KR_UNLOCK;
    IWDG_PR = IWDG_PR_32;
    IWDG_RLR = 1500U; // 1.0 s at the oscillator's fastest, 1.5 s typically
    IWDG_KR = IWDG_KR_START;
    IWDG_KR = IWDG_KR_FEED;
}

void machine_watchdog_feed(void)
{
    IWDG_KR = IWDG_KR_FEED;
}

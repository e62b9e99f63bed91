// The slot of the memory card: serial peripheral interface 2 on PB12 (select), PB13 (clock), PB14 (from the card) and
// PB15 (to the card). The task that uses the card transfers each byte itself. Every task of higher priority may
// interrupt it: the bus only pauses then.
#include <stddef.h>

#include "core.h"
#include "machine.h"
#include "machine_clock.h"
#include "pause.h"
#include "registers.h"

static const uint32_t slow_hz = 400000U;
static const uint32_t fast_hz = 12000000U; ///< a card allows 25 MHz, but the wires to a slot do not

enum
{
    byte_polls = 100000 ///< a byte at the slow clock takes about 5000 cycles
};

/// Wait until `mask` of the status is as `wanted`; false after too many polls.
static bool becomes(uint32_t mask, uint32_t wanted)
{
    for (uint32_t i = 0U; i < (uint32_t)byte_polls; i++)
    {
        if ((SPI2_SR & mask) == wanted)
        {
            return true;
        }
    }
    return false;
}

static void set_fast(void* context, bool fast)
{
    (void)context;
    const uint32_t most_hz = fast ? fast_hz : slow_hz;
    uint32_t divider = 0U; // by 2, 4, ... 256
    while (divider < SPI2_CR1_DIVIDER_MAX && (machine_slow_bus_hz >> (divider + 1U)) > most_hz)
    {
        divider++;
    }
    SPI2_CR1 = SPI2_CR1_MASTER | SPI2_CR1_SOFTWARE_SELECT | (divider << SPI2_CR1_DIVIDER_SHIFT);
    (void)SPI2_DR; // read a byte that an abandoned exchange may have left
    SPI2_CR1 |= SPI2_CR1_ENABLE;
}

static void choose(void* context, bool on)
{
    (void)context;
    GPIOB_BSRR = on ? GPIO_BSRR_CLEAR(CARD_SELECT_PIN) : GPIO_BSRR_SET(CARD_SELECT_PIN);
}

static bool exchange(void* context, const uint8_t* out, uint8_t* in, size_t size)
{
    (void)context;
    for (size_t i = 0U; i < size; i++)
    {
        if (!becomes(SPI2_SR_TXE, SPI2_SR_TXE))
        {
            return false;
        }
        SPI2_DR = out != NULL ? out[i] : 0xFFU;
        if (!becomes(SPI2_SR_RXNE, SPI2_SR_RXNE))
        {
            return false;
        }
        const uint8_t received = (uint8_t)SPI2_DR;
        if (in != NULL)
        {
            in[i] = received;
        }
    }
    // Now the select line and the clock's divider may change.
    return becomes(SPI2_SR_BUSY, 0U);
}

const spi_t* machine_card_bus(void)
{
    static const spi_t bus = {
        .context = NULL, .set_fast = set_fast, .select = choose, .exchange = exchange, .pause = pause_a_millisecond};
    RCC_AHB1ENR |= RCC_AHB1ENR_GPIOB;
    RCC_APB1ENR |= RCC_APB1ENR_SPI2;
    core_barrier(); // a peripheral can be used two cycles after its clock is on
    choose(NULL, false);
    // Pins 13 to 15 to their function 5, pin 12 driven by software. The card's line is pulled up, so that an empty slot
    // reads as an idle line.
    GPIOB_AFRH = (GPIOB_AFRH & ~(0xFFFU << 20U)) | (0x555U << 20U);
    GPIOB_PUPDR = (GPIOB_PUPDR & ~(0xFFU << 24U)) | (1U << 28U);
    GPIOB_OSPEEDR = (GPIOB_OSPEEDR & ~(0xFFU << 24U)) | (0x55U << 24U);
    GPIOB_MODER = (GPIOB_MODER & ~(0xFFU << 24U)) | (0xA9U << 24U);
    set_fast(NULL, false);
    return &bus;
}

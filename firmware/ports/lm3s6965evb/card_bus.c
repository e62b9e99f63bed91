// The card's slot: synchronous serial interface 0, selected by pin D0.
#include <stddef.h>

#include "machine.h"
#include "pause.h"
#include "registers.h"

enum
{
    slow_divider = 32, ///< 390 kHz
    fast_divider = 2,
    byte_polls = 100000
};

static bool becomes(uint32_t bit)
{
    for (uint32_t i = 0U; i < (uint32_t)byte_polls; i++)
    {
        if ((SSI0_SR & bit) != 0U)
        {
            return true;
        }
    }
    return false;
}

static void set_fast(void* context, bool fast)
{
    (void)context;
    SSI0_CR1 = 0U;
    SSI0_CR0 = SSI0_CR0_8_BITS;
    SSI0_CPSR = fast ? (uint32_t)fast_divider : (uint32_t)slow_divider;
    SSI0_CR1 = SSI0_CR1_ENABLE;
}

static void choose(void* context, bool on)
{
    (void)context;
    GPIOD_DATA_PIN_0 = on ? 0U : 1U;
}

static bool exchange(void* context, const uint8_t* out, uint8_t* in, size_t size)
{
    (void)context;
    for (size_t i = 0U; i < size; i++)
    {
        if (!becomes(SSI0_SR_TRANSMITTER_TAKES))
        {
            return false;
        }
        SSI0_DR = out != NULL ? out[i] : 0xFFU;
        if (!becomes(SSI0_SR_RECEIVER_HOLDS))
        {
            return false;
        }
        const uint8_t received = (uint8_t)SSI0_DR;
        if (in != NULL)
        {
            in[i] = received;
        }
    }
    return true;
}

const spi_t* machine_card_bus(void)
{
    static const spi_t bus = {
        .context = NULL, .set_fast = set_fast, .select = choose, .exchange = exchange, .pause = pause_a_millisecond};
    GPIOD_DEN |= 1U;
    GPIOD_DIR |= 1U;
    choose(NULL, false);
    set_fast(NULL, false);
    return &bus;
}

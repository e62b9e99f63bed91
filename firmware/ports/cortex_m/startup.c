#include "startup.h"

#include <stddef.h>

#include "core.h"
#include "restart.h"

// Set by the linker script.
extern uint32_t image_stack_end[];
extern uint32_t image_data_start[];
extern uint32_t image_data_end[];
extern const uint32_t image_data_stored[];
extern uint32_t image_bss_start[];
extern uint32_t image_bss_end[];

// The kernel's handlers, by the names of its port; the tick's is named by the core's manual.
void vPortSVCHandler(void);
void xPortPendSVHandler(void);
void xPortSysTickHandler(void);

void startup_reset(void);
int main(void);

void startup_fault(void)
{
    restart_because("processor fault");
}

/// The core's part of the vector table; the linker puts the machine's interrupts right behind it.
__attribute__((section(".vectors.core"), used)) static const startup_vector_t core_vectors[] = {
    {.stack = image_stack_end}, {.handler = startup_reset},      {.handler = startup_fault}, // NMI
    {.handler = startup_fault},                                                              // hard fault
    {.handler = startup_fault},                                                              // memory management
    {.handler = startup_fault},                                                              // bus
    {.handler = startup_fault},                                                              // usage
    {.handler = startup_fault}, {.handler = startup_fault},      {.handler = startup_fault},
    {.handler = startup_fault}, {.handler = vPortSVCHandler},    {.handler = startup_fault}, // debug monitor
    {.handler = startup_fault}, {.handler = xPortPendSVHandler}, {.handler = xPortSysTickHandler},
};

void startup_reset(void)
{
    CORE_COPROCESSORS |= CORE_COPROCESSORS_FPU;
    core_barrier();
    // A boot loader may have put the image at another address.
    CORE_VECTOR_TABLE = (uint32_t)(uintptr_t)core_vectors;
    const uint32_t* from = image_data_stored;
    for (uint32_t* to = image_data_start; to < image_data_end; to++)
    {
        *to = *from++;
    }
    for (uint32_t* to = image_bss_start; to < image_bss_end; to++)
    {
        *to = 0U;
    }
    (void)main();
    restart_because("the program ended");
}

#include "app/application.h"

#include "app/application_reset.h"
#include "app/application_state.h"
#include "app/task_bodies.h"

/// Bytes have come in: wake UartRxTask, which fetches them.
static bool on_receive_interrupt(void* context)
{
    const application_t* const app = context;
    BaseType_t woken = pdFALSE;
    vTaskNotifyGiveFromISR(app->handles[task_uart_rx], &woken);
    return woken != pdFALSE;
}

_Noreturn void application_run(const application_hardware_t* hardware)
{
    static application_t application;
    static StaticTask_t tasks[task_count];
    static StackType_t stacks[task_stack_words];

    application_t* const app = &application;
    app->hardware = *hardware;
    app->board_mutex = xSemaphoreCreateMutexStatic(&app->board_mutex_memory);
    app->card_mutex = xSemaphoreCreateMutexStatic(&app->card_mutex_memory);
    mailbox_init(&app->received);
    mailbox_init(&app->transmitted);
    application_reset(app, app->hardware.restart_reason != NULL);
    watch_begin(&app->watch, app->hardware.watchdog.patience, application_kernel_ms());
    size_t used_words = 0;
    for (size_t i = 0; i < task_count; i++)
    {
        app->load.tasks[i].processor = task_table[i].processor;
        configASSERT(used_words + task_table[i].stack_words <= task_stack_words);
        app->handles[i] = xTaskCreateStatic(task_bodies[i], task_table[i].name, task_table[i].stack_words, app,
                                            task_table[i].priority, stacks + used_words, &tasks[i]);
        used_words += task_table[i].stack_words;
    }
    app->received.reader = app->handles[task_tty];
    app->transmitted.reader = app->handles[task_uart_tx];
    app->hardware.uart.on_receive(app->hardware.uart.context, on_receive_interrupt, app);
    vTaskStartScheduler();
    for (;;)
    {
        // The scheduler returns only when it has no memory to start, and all its memory is static.
        configASSERT(false);
    }
}

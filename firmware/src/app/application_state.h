/// Everything that the application's tasks share. Use `board`, `shell`, `tty` and `load` only while holding
/// `board_mutex`.
#ifndef APP_APPLICATION_STATE_H
#define APP_APPLICATION_STATE_H

#include "FreeRTOS.h"
#include "semphr.h"
#include "task.h"

#include "app/application_hardware.h"
#include "app/load.h"
#include "app/mailbox.h"
#include "app/task_table.h"
#include "app/tty.h"
#include "app/watch.h"

typedef struct
{
    application_hardware_t hardware;
    board_t board;
    SemaphoreHandle_t board_mutex;
    StaticSemaphore_t board_mutex_memory;
    SemaphoreHandle_t card_mutex; ///< of the hardware's storage; never taken while `board_mutex` is held
    StaticSemaphore_t card_mutex_memory;
    mailbox_t received;    ///< from UartRxTask to ttyTask
    mailbox_t transmitted; ///< from every task to UartTxTask
    shell_t shell;
    tty_t tty;
    char reply[shell_reply_bytes];
    load_t load;
    watch_t watch;
    task_health_t health[task_count];
    uint32_t stores_asked; ///< by the station, not yet answered by cardTask
    uint32_t started_ms;
    TaskHandle_t handles[task_count];
} application_t;

void application_lock(application_t* app);
void application_unlock(application_t* app);

TickType_t application_ticks(uint32_t duration_ms);

/// Milliseconds since the board started, at power-on or by a reset.
uint32_t application_now_ms(const application_t* app);

/// Milliseconds of the kernel's clock, which no reset sets back.
uint32_t application_kernel_ms(void);

/// Note that `task` runs. Every task calls it at least each `watch_wait_ms`.
void application_hear(application_t* app, task_id_t task);

/// Wait to be woken, but not for longer than a task may be silent.
void application_wait(TickType_t ticks);

#endif

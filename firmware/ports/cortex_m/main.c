/// The board on a Cortex-M processor: connects the devices to the application. This is the board for hardware in the
/// loop: its sensors and receiver are models around the newest simulator information, as on a PC.
#include <string.h>

#include "FreeRTOS.h"

#include "app/application.h"
#include "host.h"
#include "machine.h"
#include "restart.h"
#include "sim_board.h"
#include "startup.h"
#include "uart_line.h"

int main(void);

static void feed_watchdog(void* context)
{
    bool* const is_started = context;
    if (!*is_started)
    {
        machine_watchdog_start();
        *is_started = true;
    }
    machine_watchdog_feed();
}

static void give_up(void* context, const char* task)
{
    (void)context;
    static const char words[] = "watchdog: ";
    char reason[sizeof words + configMAX_TASK_NAME_LEN] = {0};
    memcpy(reason, words, sizeof words - 1U);
    strncpy(reason + sizeof words - 1U, task, configMAX_TASK_NAME_LEN);
    restart_because(reason);
}

int main(void)
{
    static bool is_watchdog_started = false;
    machine_start();
    const application_hardware_t hardware = {
        .uart = uart_line(),
        .sensors = sim_board_sensors(1),
        .servos = sim_board_servos(),
        .storage = host_card(),
        .watchdog = {.context = &is_watchdog_started,
                     .patience = host_patience,
                     .feed = feed_watchdog,
                     .give_up = give_up},
        .restart_reason = restart_reason(),
        .hang_task = host_word_after("--hang"),
        .measures_stacks = true,
        .legacy = host_has_option("--legacy"),
    };
    application_run(&hardware);
}

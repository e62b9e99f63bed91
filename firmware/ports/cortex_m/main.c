/// The board on a Cortex-M processor: puts its devices together. Sensors and receiver are models around the newest
/// simulator information, as on a PC: this is the board for hardware in the loop.
#include "app/application.h"
#include "host.h"
#include "machine.h"
#include "sim_board.h"
#include "startup.h"
#include "uart_line.h"

int main(void);

int main(void)
{
    machine_start();
    const application_hardware_t hardware = {
        .uart = uart_line(),
        .sensors = sim_board_sensors(1),
        .servos = sim_board_servos(),
        .storage = host_card(),
        .legacy = host_has_option("--legacy"),
    };
    application_run(&hardware);
}

/// The board as a program: connects the devices to the application, and closes them on a signal.
#define _GNU_SOURCE // eventfd

#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "app/application.h"
#include "card.h"
#include "endpoint.h"
#include "kernel.h"
#include "line.h"
#include "options.h"
#include "sim_board.h"

enum
{
    exit_cannot_run = 1,
    exit_wrong_usage = 2,
    exit_hangs = 3
};

static const uint32_t watchdog_patience = 10; ///< longer deadlines, because other programs use the PC too

static int stop_fd = -1;

static void on_stop_signal(int signal_number)
{
    (void)signal_number;
    const int saved_errno = errno;
    const uint64_t one = 1;
    // It only fails when the board is being stopped already.
    if (write(stop_fd, &one, sizeof one) < 0)
    {
    }
    errno = saved_errno;
}

/// Called by the line's thread when it has closed the line. The tasks need not be ended: they leave nothing behind
/// except the card, on which no write is interrupted.
static void on_line_stopped(void)
{
    card_settle();
    exit(EXIT_SUCCESS);
}

static void stop_on_signals(void)
{
    static const int stop_signals[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = on_stop_signal;
    sigfillset(&action.sa_mask);
    for (size_t i = 0; i < sizeof stop_signals / sizeof stop_signals[0]; i++)
    {
        (void)sigaction(stop_signals[i], &action, NULL);
    }
    action.sa_handler = SIG_IGN; // a station that closes its connection must not end the board
    (void)sigaction(SIGPIPE, &action, NULL);
}

static void feed_watchdog(void* context)
{
    (void)context; // a PC has no watchdog besides the board's own
}

/// A real board restarts here; this program ends, and whoever started it may start it again. As after a power cut, the
/// card keeps its contents.
static void give_up(void* context, const char* task)
{
    (void)context;
    (void)fprintf(stderr, "epf-board: the watchdog ends the board: %s hangs\n", task);
    (void)fflush(stderr);
    _exit(exit_hangs);
}

static bool open_line(endpoint_t* endpoint, const options_t* options, char error[endpoint_error_bytes])
{
    switch (options->line)
    {
    case options_line_pty:
        return endpoint_open_pty(endpoint, options->path, error);
    case options_line_tcp:
        return endpoint_open_tcp(endpoint, options->port, error);
    case options_line_serial:
        break;
    }
    return endpoint_open_serial(endpoint, options->path, error);
}

int main(int argc, char* argv[])
{
    static endpoint_t endpoint;
    static char error[endpoint_error_bytes];
    options_t options;
    const options_result_t parsed = options_parse(&options, argc, argv, error, sizeof error);
    if (parsed != options_run)
    {
        if (parsed == options_wrong)
        {
            (void)fprintf(stderr, "epf-board: %s\n", error);
        }
        return parsed == options_shown ? EXIT_SUCCESS : exit_wrong_usage;
    }
    kernel_init();
    stop_fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    stop_on_signals();
    if ((options.card != NULL && !card_start(options.card, error, sizeof error)) ||
        !open_line(&endpoint, &options, error))
    {
        (void)fprintf(stderr, "epf-board: %s\n", error);
        return exit_cannot_run;
    }
    if (stop_fd < 0 || !line_start(&endpoint, stop_fd, on_line_stopped))
    {
        (void)fprintf(stderr, "epf-board: no thread for the line: %s.\n", strerror(errno));
        endpoint.close(&endpoint);
        return exit_cannot_run;
    }
    (void)printf("epf-board: ready on %s%s\n", endpoint.name, options.legacy ? ", as a deployed board" : "");
    (void)fflush(stdout);
    const application_hardware_t hardware = {
        .uart = line_uart(),
        .sensors = sim_board_sensors(options.seed),
        .servos = sim_board_servos(),
        .storage = card_storage(),
        .watchdog = {.patience = watchdog_patience, .feed = feed_watchdog, .give_up = give_up},
        .hang_task = options.hang_task,
        .legacy = options.legacy,
        .hil_period_ms = options.hil_period_ms,
    };
    application_run(&hardware);
}

#define _GNU_SOURCE // getopt_long

#include "options.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/task_table.h"
#include "flight/board.h"

static const char help[] =
    "epf-board: the autopilot board's firmware as a program of this computer\n"
    "\n"
    "Usage: epf-board (--pty PATH | --tcp PORT | --serial DEVICE) [options]\n"
    "\n"
    "The serial line, exactly one of\n"
    "  --pty PATH          make PATH a link to a new raw pseudo-terminal; a station opens PATH like a serial port,\n"
    "                      closes it and opens it again; the link is removed at the end\n"
    "  --tcp PORT          listen on 127.0.0.1:PORT for one station at a time; 0 takes a free port and prints it\n"
    "  --serial DEVICE     use a real serial port with 115200 8N1, such as /dev/ttyUSB0; it may be unplugged and\n"
    "                      plugged in again\n"
    "\n"
    "Options\n"
    "  --card DIR          the board's memory card: parameters and uploaded plans are kept in the file card.img\n"
    "                      of this folder (made when missing) and read at start; without it nothing can be stored\n"
    "  --legacy            behave like a deployed board, without extension commands (0x100 and up)\n"
    "  --hil-period-ms N   let each command 50 stand for N ms (1..1000) of flight, for a simulator in lock-step;\n"
    "                      0, the default, measures the time between two commands\n"
    "  --hang TASK         make this task (a name from the shell's `tasks`) hang after a second, to test the watchdog\n"
    "  --seed N            seed of the sensors' noise (0..4294967295, default 1)\n"
    "  --version           print the version and end\n"
    "  --help              print this and end\n"
    "\n"
    "One line is printed when the board is ready. It ends on SIGINT (Ctrl-C), SIGTERM or SIGHUP with exit code 0; a "
    "wrong\n"
    "command line ends it with 2, a line or card that cannot be used with 1, a task that hangs with 3.\n"
    "\n"
    "The line begins in text mode: write `help` and a line end. A station sends `#QT` and a line feed to open binary "
    "mode.\n"
    "\n"
    "Examples\n"
    "  epf-board --pty ./board --card ./card     then: picocom ./board, or the station's link pty://./board\n"
    "  epf-board --tcp 5760                      then: nc 127.0.0.1 5760, or the station's link tcp://127.0.0.1:5760\n";

static bool parse_number(const char* text, unsigned long maximum, unsigned long* number)
{
    char* end = NULL;
    errno = 0;
    *number = strtoul(text, &end, 10);
    return errno == 0 && end != text && *end == '\0' && strchr(text, '-') == NULL && *number <= maximum;
}

enum
{
    option_pty = 1000,
    option_tcp,
    option_serial,
    option_card,
    option_legacy,
    option_hil_period_ms,
    option_hang,
    option_seed,
    option_version,
    option_help
};

static const struct option long_options[] = {
    {"pty", required_argument, NULL, option_pty},
    {"tcp", required_argument, NULL, option_tcp},
    {"serial", required_argument, NULL, option_serial},
    {"card", required_argument, NULL, option_card},
    {"legacy", no_argument, NULL, option_legacy},
    {"hil-period-ms", required_argument, NULL, option_hil_period_ms},
    {"hang", required_argument, NULL, option_hang},
    {"seed", required_argument, NULL, option_seed},
    {"version", no_argument, NULL, option_version},
    {"help", no_argument, NULL, option_help},
    {NULL, 0, NULL, 0},
};

/// Read the number of an option; false, with a sentence, when it is not a number or too large.
static bool take_number(const char* name, unsigned long maximum, unsigned long* number, char* error, size_t error_bytes)
{
    if (parse_number(optarg, maximum, number))
    {
        return true;
    }
    (void)snprintf(error, error_bytes, "%s %s: a whole number from 0 to %lu is needed.", name, optarg, maximum);
    return false;
}

static bool is_task(const char* name)
{
    for (size_t i = 0; i < task_count; i++)
    {
        if (strcmp(name, task_table[i].name) == 0)
        {
            return true;
        }
    }
    return false;
}

/// Put one option into `options`; false, with a sentence, when its value is wrong.
static bool take(options_t* options, int option, char* error, size_t error_bytes)
{
    unsigned long number = 0;
    bool good = true;
    switch (option)
    {
    case option_pty:
    case option_serial:
        options->line = option == option_pty ? options_line_pty : options_line_serial;
        options->path = optarg;
        break;
    case option_tcp:
        options->line = options_line_tcp;
        good = take_number("--tcp", 65535, &number, error, error_bytes);
        options->port = (unsigned int)number;
        break;
    case option_card:
        options->card = optarg;
        break;
    case option_legacy:
        options->legacy = true;
        break;
    case option_hil_period_ms:
        good = take_number("--hil-period-ms", 1000, &number, error, error_bytes);
        options->hil_period_ms = (uint32_t)number;
        break;
    case option_hang:
        options->hang_task = optarg;
        good = is_task(optarg);
        if (!good)
        {
            (void)snprintf(error, error_bytes, "--hang %s: no task has that name; the shell's `tasks` lists them.",
                           optarg);
        }
        break;
    default:
        good = take_number("--seed", UINT32_MAX, &number, error, error_bytes);
        options->seed = (uint32_t)number;
        break;
    }
    return good;
}

/// Handle one option that getopt found. Anything but `options_run` ends the program.
static options_result_t take_found(options_t* options, int option, const char* argument, char* error,
                                   size_t error_bytes)
{
    if (option == option_help)
    {
        (void)fputs(help, stdout);
        return options_shown;
    }
    if (option == option_version)
    {
        (void)puts(BOARD_FIRMWARE_NAME " " BOARD_FIRMWARE_VERSION);
        return options_shown;
    }
    if (option == '?' || option == ':')
    {
        (void)snprintf(error, error_bytes, "%s: %s; `epf-board --help` lists the options.", argument,
                       option == ':' ? "a value is needed after it" : "there is no such option");
        return options_wrong;
    }
    return take(options, option, error, error_bytes) ? options_run : options_wrong;
}

options_result_t options_parse(options_t* options, int argc, char* argv[], char* error, size_t error_bytes)
{
    *options = (options_t){.seed = 1};
    int lines = 0;
    opterr = 0;
    for (int option = 0; (option = getopt_long(argc, argv, ":", long_options, NULL)) != -1;)
    {
        const options_result_t result = take_found(options, option, argv[optind - 1], error, error_bytes);
        if (result != options_run)
        {
            return result;
        }
        lines += option == option_pty || option == option_tcp || option == option_serial ? 1 : 0;
    }
    if (optind < argc)
    {
        (void)snprintf(error, error_bytes, "%s: not an option; `epf-board --help` lists them.", argv[optind]);
        return options_wrong;
    }
    if (lines != 1)
    {
        (void)snprintf(error, error_bytes,
                       "%s --pty PATH, --tcp PORT or --serial DEVICE is needed; see "
                       "`epf-board --help`.",
                       lines == 0 ? "One of" : "Exactly one of");
        return options_wrong;
    }
    return options_run;
}

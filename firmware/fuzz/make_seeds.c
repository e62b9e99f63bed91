// Writes the seeds of the fuzz targets: the vectors that all languages share, and uploads of the project's routes.
//
//     make_seeds FOLDER
//
// Makes FOLDER/frame, FOLDER/interpreter and FOLDER/mission, one file for each seed.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "comms/frame.h"
#include "comms/protocol_gen.h"
#include "navigation/routes_gen.h"
#include "vectors_gen.h"

enum
{
    seed_bytes = 8192,
    path_bytes = 512
};

typedef struct
{
    uint8_t bytes[seed_bytes];
    size_t size;
} seed_t;

// Choices (fuzz.h): which dialect, which board. A seed for binary mode begins with the line that opens it.
static const uint32_t to_board = 3U;   ///< dialect 0
static const uint32_t from_board = 1U; ///< dialect 1
static const uint32_t with_card = 0x203U;
static const uint32_t legacy = 0x103U;
static const char opening[] = "#QT\n";

static void stop(const char* what)
{
    (void)fprintf(stderr, "make_seeds: %s: %s\n", what, strerror(errno));
    exit(1);
}

static void add(seed_t* seed, const void* bytes, size_t size)
{
    if (seed->size + size > sizeof seed->bytes)
    {
        errno = EFBIG;
        stop("a seed");
    }
    memcpy(seed->bytes + seed->size, bytes, size);
    seed->size += size;
}

static void begin(seed_t* seed, uint32_t choices)
{
    seed->size = sizeof choices;
    protocol_put_u32(seed->bytes, choices);
}

static void make_folder(const char* path)
{
    if (mkdir(path, 0777) != 0 && errno != EEXIST)
    {
        stop(path);
    }
}

static void write_seed(const char* folder, const char* target, const seed_t* seed)
{
    static unsigned int number;
    char path[path_bytes];
    (void)snprintf(path, sizeof path, "%s/%s/%04u", folder, target, number++);
    FILE* const file = fopen(path, "wb");
    if (file == NULL || fwrite(seed->bytes, 1U, seed->size, file) != seed->size || fclose(file) != 0)
    {
        stop(path);
    }
}

static void add_command(seed_t* seed, uint32_t type_id, const uint8_t* payload, size_t size)
{
    uint8_t frame[frame_max_bytes];
    add(seed, frame, frame_encode(&frame_to_board, type_id, payload, size, frame, sizeof frame));
}

/// One route as a station uploads it and reads it back.
static void add_upload(seed_t* seed, const route_t* route, int32_t plan)
{
    uint8_t payload[COMMAND_MISSION_ITEM_SIZE];
    const command_mission_begin_t announced = {.plan = plan, .count = (int32_t)route->count};
    command_mission_begin_pack(&announced, payload);
    add_command(seed, COMMAND_MISSION_BEGIN_ID, payload, COMMAND_MISSION_BEGIN_SIZE);
    for (size_t i = 0; i < route->count; i++)
    {
        const route_waypoint_t* const from = &route->waypoints[i];
        const command_mission_item_t item = {
            .plan = plan,
            .index = (int32_t)i,
            .latitude_deg = from->latitude_deg,
            .longitude_deg = from->longitude_deg,
            .altitude_ft = from->altitude_ft,
            .speed_kt = from->speed_kt,
        };
        command_mission_item_pack(&item, payload);
        add_command(seed, COMMAND_MISSION_ITEM_ID, payload, sizeof payload);
    }
    protocol_put_i32(payload, plan);
    add_command(seed, COMMAND_MISSION_COMMIT_ID, payload, COMMAND_MISSION_COMMIT_SIZE);
    add_command(seed, COMMAND_MISSION_READ_ID, payload, COMMAND_MISSION_READ_SIZE);
}

static void write_uploads(const char* folder)
{
    for (size_t i = 0; i < ROUTE_COUNT; i++)
    {
        seed_t seed;
        begin(&seed, to_board);
        add_command(&seed, routes[i].load_command, NULL, 0U);
        add_upload(&seed, &routes[i], (int32_t)(i % 2U));
        write_seed(folder, "mission", &seed);
        seed_t opened;
        begin(&opened, with_card);
        add(&opened, opening, sizeof opening - 1U);
        add_command(&opened, COMMAND_CAPABILITIES_ID, NULL, 0U);
        add(&opened, seed.bytes + 4, seed.size - 4U);
        write_seed(folder, "interpreter", &opened);
    }
}

static void write_streams(const char* folder)
{
    for (size_t i = 0; i < sizeof stream_vectors / sizeof stream_vectors[0]; i++)
    {
        seed_t seed;
        begin(&seed, stream_vectors[i].dialect == &frame_to_board ? to_board : from_board);
        add(&seed, stream_vectors[i].bytes, stream_vectors[i].size);
        write_seed(folder, "frame", &seed);
    }
    for (size_t i = 0; i < sizeof telemetry_vectors / sizeof telemetry_vectors[0]; i++)
    {
        seed_t seed;
        begin(&seed, from_board);
        add(&seed, telemetry_vectors[i].bytes, telemetry_vectors[i].size);
        write_seed(folder, "frame", &seed);
    }
}

/// Commands of the deployed station, a few in each seed, after the line that opens binary mode.
static void write_commands(const char* folder)
{
    static const uint32_t boards[] = {to_board, with_card, legacy};
    enum
    {
        controls_a_seed = 8
    };
    const size_t count = sizeof command_vectors / sizeof command_vectors[0];
    for (size_t i = 0; i < count; i += controls_a_seed)
    {
        seed_t seed;
        begin(&seed, boards[(i / controls_a_seed) % (sizeof boards / sizeof boards[0])]);
        add(&seed, opening, sizeof opening - 1U);
        for (size_t k = i; k < count && k < i + controls_a_seed; k++)
        {
            add(&seed, command_vectors[k].bytes, command_vectors[k].size);
        }
        write_seed(folder, "interpreter", &seed);
        write_seed(folder, "frame", &seed);
        write_seed(folder, "mission", &seed);
    }
}

/// Lines as people type them, and the AHRS test.
static void write_lines(const char* folder)
{
    static const char* const lines[] = {
        "help\nversion\nstatus\n",
        "#sim\r#s00",
        "param\nparam k_roll 12.5\nparam store\nparam load\n",
        "fms\nhil\nhil load gando\nstream all on\nrate param 20\n",
        "rc auto on\nrc power off\nreset\n",
        "tasks\nsensors\nservos\nservo 3 -0.5\n",
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++)
    {
        seed_t seed;
        begin(&seed, with_card);
        // with the zero byte, which ends the order that starts the AHRS test
        add(&seed, lines[i], strlen(lines[i]) + 1U);
        write_seed(folder, "interpreter", &seed);
    }
}

int main(int count, char** arguments)
{
    static const char* const targets[] = {"frame", "interpreter", "mission"};
    if (count != 2)
    {
        (void)fprintf(stderr, "usage: make_seeds FOLDER\n");
        return 2;
    }
    const char* const folder = arguments[1];
    make_folder(folder);
    for (size_t i = 0; i < sizeof targets / sizeof targets[0]; i++)
    {
        char path[path_bytes];
        (void)snprintf(path, sizeof path, "%s/%s", folder, targets[i]);
        make_folder(path);
    }
    write_streams(folder);
    write_commands(folder);
    write_uploads(folder);
    write_lines(folder);
    return 0;
}

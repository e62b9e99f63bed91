#include "epf_flight.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "flight/board.h"

enum
{
    queue_bytes = 16384 ///< a whole plan of 100 waypoints and all streams, twice
};

struct flight
{
    board_t board;
    frame_decoder_t decoder;
    uint32_t now_ms;
    float hil_ms; ///< time of HIL steps that is not in `now_ms` yet
    uint8_t queue[queue_bytes];
    size_t queued;
    size_t lost;
};

static void enqueue(void* context, const uint8_t* frame, size_t size)
{
    flight_t* const flight = context;
    if (flight->queued + size > sizeof flight->queue)
    {
        flight->lost += size;
        return;
    }
    memcpy(flight->queue + flight->queued, frame, size);
    flight->queued += size;
}

flight_t* epf_flight_new(float hil_period_s)
{
    flight_t* const flight = calloc(1, sizeof *flight);
    if (flight != NULL)
    {
        const board_config_t config = {.hil_period_s = hil_period_s, .send = enqueue, .send_context = flight};
        board_init(&flight->board, &config);
        board_open(&flight->board, 0);
        frame_decoder_init(&flight->decoder, &board_frames_in);
    }
    return flight;
}

void epf_flight_free(flight_t* flight)
{
    free(flight);
}

void epf_flight_advance(flight_t* flight, uint32_t elapsed_ms)
{
    flight->now_ms += elapsed_ms;
    board_supervise_hil(&flight->board, flight->now_ms);
    while (board_tick(&flight->board, flight->now_ms))
    {
    }
}

static void handle(flight_t* flight, const frame_t* frame)
{
    if (frame->type_id == COMMAND_XPLANE_INFO_ID)
    {
        flight->hil_ms += flight->board.hil.period_s * 1000.0F;
        const uint32_t whole_ms = (uint32_t)flight->hil_ms;
        flight->hil_ms -= (float)whole_ms;
        flight->now_ms += whole_ms;
    }
    board_note_frames(&flight->board, flight->decoder.received, frame_decoder_rejected(&flight->decoder));
    (void)board_handle_command(&flight->board, frame->type_id, frame->payload, frame->payload_size, flight->now_ms);
    epf_flight_advance(flight, 0);
}

size_t epf_flight_feed(flight_t* flight, const uint8_t* in, size_t size, uint8_t* out, size_t capacity)
{
    while (size > 0)
    {
        const size_t taken = frame_decoder_feed(&flight->decoder, in, size);
        in += taken;
        size -= taken;
        frame_t frame;
        for (;;)
        {
            const frame_event_t event = frame_decoder_next(&flight->decoder, &frame);
            if (event == frame_event_none)
            {
                break;
            }
            if (event == frame_event_greeting)
            {
                board_open(&flight->board, flight->now_ms);
                continue;
            }
            handle(flight, &frame);
        }
    }
    const size_t given = flight->queued < capacity ? flight->queued : capacity;
    if (given > 0)
    {
        memcpy(out, flight->queue, given);
        memmove(flight->queue, flight->queue + given, flight->queued - given);
        flight->queued -= given;
    }
    return given;
}

void epf_flight_send_streams(flight_t* flight, uint32_t task)
{
    if (task < telemetry_task_count)
    {
        board_send_streams(&flight->board, (telemetry_task_t)task);
    }
}

void epf_flight_supervise(flight_t* flight)
{
    board_supervise_hil(&flight->board, flight->now_ms);
}

void epf_flight_step(flight_t* flight, const epf_flight_readings_t* readings, float dt_s)
{
    board_sensors_t* const sensors = &flight->board.measured.sensors;
    sensors->ahrs = (message_ahrs_t){readings->yaw_deg, readings->pitch_deg, readings->roll_deg};
    sensors->inertial.gx_rad_s = readings->p_rad_s;
    sensors->inertial.gy_rad_s = readings->q_rad_s;
    sensors->inertial.gz_rad_s = readings->r_rad_s;
    sensors->analog.altitude_m = readings->altitude_m;
    sensors->analog.vvi_ft_min = readings->vvi_ft_min;
    sensors->analog.calibrated_airspeed_kt = readings->calibrated_airspeed_kt;
    sensors->gps.latitude_deg = readings->gps_latitude_deg;
    sensors->gps.longitude_deg = readings->gps_longitude_deg;
    sensors->gps.altitude_m = readings->gps_altitude_m;
    sensors->gps.speed_kt = readings->gps_speed_kt;
    sensors->gps.heading_deg = readings->gps_heading_deg;
    sensors->gps.valid = isfinite(readings->gps_latitude_deg) ? 'A' : 'V';
    memcpy(sensors->servos_in.channel, readings->channel, sizeof sensors->servos_in.channel);
    board_flight_step(&flight->board, dt_s);
}

void epf_flight_positions(const flight_t* flight, float positions[epf_flight_servos])
{
    board_servo_positions(&flight->board, positions);
}

size_t epf_flight_lost_bytes(const flight_t* flight)
{
    return flight->lost;
}

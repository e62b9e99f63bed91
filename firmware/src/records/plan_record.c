#include "records/plan_record.h"

#include <stdbool.h>

#include "common/bytes.h"
#include "records/record_store.h"

enum
{
    count_bytes = 4,
    first_waypoint_offset = record_payload_offset + count_bytes,
    longitude_offset = 8,
    altitude_offset = 16,
    speed_offset = 20
};

static const record_kind_t kinds[] = {
    [plan_record_flight] = {.name = "plan.flight", .magic = 0x46504C46U, .version = 1U}, // "FLPF"
    [plan_record_hil] = {.name = "plan.hil", .magic = 0x46504C48U, .version = 1U},       // "HLPF"
};

static void write_waypoint(uint8_t* bytes, const waypoint_t* waypoint)
{
    bytes_write_f64(bytes, waypoint->position.latitude_deg);
    bytes_write_f64(bytes + longitude_offset, waypoint->position.longitude_deg);
    bytes_write_f32(bytes + altitude_offset, waypoint->altitude_ft);
    bytes_write_f32(bytes + speed_offset, waypoint->speed_kt);
}

static waypoint_t read_waypoint(const uint8_t* bytes)
{
    return (waypoint_t){
        .position = {.latitude_deg = bytes_read_f64(bytes), .longitude_deg = bytes_read_f64(bytes + longitude_offset)},
        .altitude_ft = bytes_read_f32(bytes + altitude_offset),
        .speed_kt = bytes_read_f32(bytes + speed_offset),
    };
}

static const uint8_t* waypoint_at(const uint8_t* room, size_t index)
{
    return room + first_waypoint_offset + (size_t)plan_record_waypoint_bytes * index;
}

/// How many waypoints the record of `size` bytes holds; 0 when its length and its count do not agree.
static size_t count_of(const uint8_t* room, size_t size)
{
    const uint32_t count = bytes_read_u32(room + record_payload_offset);
    const bool is_possible = count >= 1U && count <= (uint32_t)plan_waypoints_max;
    const size_t wanted =
        (size_t)record_frame_bytes + (size_t)count_bytes + (size_t)plan_record_waypoint_bytes * (size_t)count;
    return is_possible && size == wanted ? (size_t)count : 0U;
}

record_state_t plan_record_load(const storage_t* storage, plan_record_of_t which, plan_t* plan, uint8_t* room,
                                size_t capacity)
{
    size_t size = 0U;
    uint32_t version = 0U;
    const record_state_t state = record_load(storage, &kinds[which], room, capacity, &size, &version);
    if (state != record_whole)
    {
        return state;
    }
    const size_t count =
        version == kinds[which].version && size > (size_t)first_waypoint_offset ? count_of(room, size) : 0U;
    for (size_t i = 0U; i < count; i++)
    {
        const waypoint_t waypoint = read_waypoint(waypoint_at(room, i));
        if (!waypoint_is_valid(&waypoint))
        {
            return record_damaged;
        }
    }
    if (count == 0U)
    {
        return record_damaged;
    }
    plan_clear(plan);
    for (size_t i = 0U; i < count; i++)
    {
        plan->waypoints[i] = read_waypoint(waypoint_at(room, i));
    }
    plan->count = count;
    return record_whole;
}

size_t plan_record_take(const plan_t* plan, uint8_t* room)
{
    bytes_write_u32(room + record_payload_offset, (uint32_t)plan->count);
    for (size_t i = 0U; i < plan->count; i++)
    {
        write_waypoint(room + first_waypoint_offset + (size_t)plan_record_waypoint_bytes * i, &plan->waypoints[i]);
    }
    return (size_t)count_bytes + (size_t)plan_record_waypoint_bytes * plan->count;
}

record_state_t plan_record_save(const storage_t* storage, plan_record_of_t which, uint8_t* room, size_t capacity,
                                size_t taken)
{
    return record_save(storage, &kinds[which], room, capacity, taken);
}

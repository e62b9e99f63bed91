#include "flight/own_topics.h"

#include <math.h>
#include <string.h>

#include "common/angle.h"
#include "common/bytes.h"
#include "common/units.h"

#define COUNT_OF(fields) (sizeof(fields) / sizeof((fields)[0]))

static const own_topic_field_t wind_fields[] = {
    {"from_deg", "deg", "clockwise from true north", 0.0F, 360.0F, own_topic_f32},
    {"speed_kt", "kt", "", 0.0F, 200.0F, own_topic_f32},
    {"uncertainty_kt", "kt", "one standard deviation, where it is largest", 0.0F, 50.0F, own_topic_f32},
};

static const own_topic_field_t line_law_fields[] = {
    {"off_line_m", "m", "right of the line", -100000.0F, 100000.0F, own_topic_f32},
    {"course_deg", "deg", "clockwise from true north", 0.0F, 360.0F, own_topic_f32},
    {"bank_wanted_deg", "deg", "right wing down", -90.0F, 90.0F, own_topic_f32},
    {"ground_speed_kt", "kt", "along the track", 0.0F, 500.0F, own_topic_f32},
    {"is_slow", "1", "faster than planned, against the wind", 0.0F, 1.0F, own_topic_flag},
};

_Static_assert(COUNT_OF(wind_fields) <= own_topic_fields_max, "its values have room");
_Static_assert(COUNT_OF(line_law_fields) <= own_topic_fields_max, "its values have room");

static const own_topic_t definitions[own_topic_count] = {
    [own_topic_wind] = {"wind", "The wind as the line law estimates it.", 0x1000U, 500U, COUNT_OF(wind_fields),
                        wind_fields},
    [own_topic_line_law] = {"line_law", "What the line law holds while it flies.", 0x1001U, 200U,
                            COUNT_OF(line_law_fields), line_law_fields},
};

const own_topic_t* own_topics_definition(own_topic_id_t topic)
{
    return &definitions[topic];
}

void own_topics_switch(own_topics_t* topics, bool is_on, uint32_t now_ms)
{
    if (is_on && !topics->is_on)
    {
        for (size_t i = 0U; i < (size_t)own_topic_count; i++)
        {
            topics->due_ms[i] = now_ms - definitions[i].period_ms;
        }
    }
    topics->is_on = is_on;
}

bool own_topics_is_due(own_topics_t* topics, own_topic_id_t topic, uint32_t now_ms)
{
    const uint32_t period_ms = definitions[topic].period_ms;
    const uint32_t elapsed_ms = now_ms - topics->due_ms[topic];
    if (!topics->is_on || elapsed_ms < period_ms)
    {
        return false;
    }
    // far behind, the next period begins now: missed frames are not made up for in a burst
    topics->due_ms[topic] += elapsed_ms >= 2U * period_ms ? elapsed_ms : period_ms;
    return true;
}

static void find_wind(const control_loop_t* loop, float values[own_topic_fields_max])
{
    wind_estimate_t wind;
    // only the line law estimates the wind, also while the pilot flies by hand
    if (loop->has_run && loop->law == guidance_law_line && wind_estimate(&loop->line.legs.wind, &wind))
    {
        values[0] = wind.from_deg;
        values[1] = wind.speed_m_s / M_S_PER_KT;
        values[2] = wind.deviation_m_s / M_S_PER_KT;
    }
}

static void find_line_law(const own_topics_source_t* source, float values[own_topic_fields_max])
{
    const control_loop_t* const loop = source->loop;
    const line_law_t* const law = &loop->line;
    values[4] = 0.0F;
    if (loop->has_run && loop->law == guidance_law_line && loop->autopilot_was_on)
    {
        values[0] = source->has_line ? law->target.right_m : NAN;
        values[1] = angle_wrap_360(law->target.course_deg);
        values[2] = law->follow.roll_d_deg;
        values[3] = law->ground_speed_m_s / M_S_PER_KT;
        values[4] = source->has_line && law->is_slow ? 1.0F : 0.0F;
    }
}

size_t own_topics_payload(own_topic_id_t topic, const own_topics_source_t* source,
                          uint8_t payload[own_topic_payload_max_bytes])
{
    float values[own_topic_fields_max] = {NAN, NAN, NAN, NAN, NAN};
    if (topic == own_topic_wind)
    {
        find_wind(source->loop, values);
    }
    else
    {
        find_line_law(source, values);
    }
    const own_topic_t* const definition = &definitions[topic];
    size_t size = 0U;
    memset(payload, 0, own_topic_payload_max_bytes);
    for (size_t i = 0U; i < definition->field_count; i++)
    {
        if (definition->fields[i].type == own_topic_flag)
        {
            payload[size] = values[i] > 0.0F ? 1U : 0U;
            size += 1U;
        }
        else
        {
            bytes_write_f32(payload + size, values[i]);
            size += sizeof(float);
        }
    }
    return (size + 3U) / 4U * 4U;
}

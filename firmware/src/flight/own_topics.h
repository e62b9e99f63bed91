/// The topics that this board has beside the telemetry of the wire: what its line law holds, and the wind that it
/// knows. The board describes them itself (`description.h`); a station switches them on and off together.
#ifndef FLIGHT_OWN_TOPICS_H
#define FLIGHT_OWN_TOPICS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "flight/control_loop.h"

typedef enum
{
    own_topic_wind,
    own_topic_line_law,
    own_topic_count
} own_topic_id_t;

/// With the numbers of the wire.
typedef enum
{
    own_topic_f32 = 1,
    own_topic_flag = 4
} own_topic_type_t;

enum
{
    own_topic_fields_max = 5,
    own_topic_payload_max_bytes = 20 ///< whole words
};

typedef struct
{
    const char* name;
    const char* unit; ///< "1" for a plain number
    const char* sign; ///< what positive means
    float minimum;
    float maximum;
    own_topic_type_t type;
} own_topic_field_t;

typedef struct
{
    const char* name;
    const char* help;
    uint16_t type_word;
    uint16_t period_ms;
    size_t field_count;
    const own_topic_field_t* fields;
} own_topic_t;

/// Whether they are sent, and when each was due last.
typedef struct
{
    bool is_on;
    uint32_t due_ms[own_topic_count];
} own_topics_t;

/// The aircraft that they tell of.
typedef struct
{
    const control_loop_t* loop;
    bool has_line; ///< it has a plan and a position; else the line law holds a course alone
} own_topics_source_t;

const own_topic_t* own_topics_definition(own_topic_id_t topic);

/// Switch them on, the first frames at once, or off. Nothing changes where they are so already.
void own_topics_switch(own_topics_t* topics, bool is_on, uint32_t now_ms);

/// True, once in each of its periods, when `topic` is to be sent now.
bool own_topics_is_due(own_topics_t* topics, own_topic_id_t topic, uint32_t now_ms);

/// Make the payload of `topic` and return its size. What is not known is NaN, and a flag is 0 then.
size_t own_topics_payload(own_topic_id_t topic, const own_topics_source_t* source,
                          uint8_t payload[own_topic_payload_max_bytes]);

#endif

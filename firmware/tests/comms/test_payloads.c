#include "support/cmocka_all.h"

#include <string.h>

#include "comms/frame.h"
#include "comms/protocol_gen.h"

/// Every message and command with a payload that has fields: X(name, NAME).
#define EACH_PAYLOAD                                                                                                   \
    X(command_control_source, COMMAND_CONTROL_SOURCE)                                                                  \
    X(command_describe_blocks, COMMAND_DESCRIBE_BLOCKS)                                                                \
    X(command_go_to_waypoint, COMMAND_GO_TO_WAYPOINT)                                                                  \
    X(command_mission_begin, COMMAND_MISSION_BEGIN)                                                                    \
    X(command_mission_commit, COMMAND_MISSION_COMMIT)                                                                  \
    X(command_mission_item, COMMAND_MISSION_ITEM)                                                                      \
    X(command_mission_read, COMMAND_MISSION_READ)                                                                      \
    X(command_own_gain_get, COMMAND_OWN_GAIN_GET)                                                                      \
    X(command_own_gain_set, COMMAND_OWN_GAIN_SET)                                                                      \
    X(command_own_topics, COMMAND_OWN_TOPICS)                                                                          \
    X(command_select_airspeed_source, COMMAND_SELECT_AIRSPEED_SOURCE)                                                  \
    X(command_select_altitude_source, COMMAND_SELECT_ALTITUDE_SOURCE)                                                  \
    X(command_servo_out, COMMAND_SERVO_OUT)                                                                            \
    X(command_set_fms_task_rate, COMMAND_SET_FMS_TASK_RATE)                                                            \
    X(command_set_parameter_task_rate, COMMAND_SET_PARAMETER_TASK_RATE)                                                \
    X(command_set_servos_task_rate, COMMAND_SET_SERVOS_TASK_RATE)                                                      \
    X(command_xplane_info, COMMAND_XPLANE_INFO)                                                                        \
    X(message_acknowledgement, MESSAGE_ACKNOWLEDGEMENT)                                                                \
    X(message_ahrs, MESSAGE_AHRS)                                                                                      \
    X(message_analog, MESSAGE_ANALOG)                                                                                  \
    X(message_autopilot_parameters, MESSAGE_AUTOPILOT_PARAMETERS)                                                      \
    X(message_board_status, MESSAGE_BOARD_STATUS)                                                                      \
    X(message_capabilities, MESSAGE_CAPABILITIES)                                                                      \
    X(message_description, MESSAGE_DESCRIPTION)                                                                        \
    X(message_description_block, MESSAGE_DESCRIPTION_BLOCK)                                                            \
    X(message_fly_by_wire, MESSAGE_FLY_BY_WIRE)                                                                        \
    X(message_fms_hil_plan, MESSAGE_FMS_HIL_PLAN)                                                                      \
    X(message_fms_plan, MESSAGE_FMS_PLAN)                                                                              \
    X(message_gps, MESSAGE_GPS)                                                                                        \
    X(message_heartbeat, MESSAGE_HEARTBEAT)                                                                            \
    X(message_hil_step, MESSAGE_HIL_STEP)                                                                              \
    X(message_hil_surfaces, MESSAGE_HIL_SURFACES)                                                                      \
    X(message_inertial, MESSAGE_INERTIAL)                                                                              \
    X(message_mission_count, MESSAGE_MISSION_COUNT)                                                                    \
    X(message_mission_item, MESSAGE_MISSION_ITEM)                                                                      \
    X(message_own_gain, MESSAGE_OWN_GAIN)                                                                              \
    X(message_servos_in, MESSAGE_SERVOS_IN)                                                                            \
    X(message_statistics, MESSAGE_STATISTICS)

enum
{
    guard = 0xEE
};

typedef struct
{
    const char* name;
    size_t size;
    void (*take_and_put)(const uint8_t* in, uint8_t* out);
} codec_t;

#define X(name, NAME)                                                                                                  \
    static void take_and_put_##name(const uint8_t* in, uint8_t* out)                                                   \
    {                                                                                                                  \
        name##_t values;                                                                                               \
        memset(&values, 0xA5, sizeof values);                                                                          \
        name##_unpack(&values, in);                                                                                    \
        name##_pack(&values, out);                                                                                     \
    }
EACH_PAYLOAD
#undef X

#define X(name, NAME) {#name, NAME##_SIZE, take_and_put_##name},
static const codec_t codecs[] = {EACH_PAYLOAD};
#undef X

/// Bytes that are all different in one payload, none of them a number that arithmetic would change.
static void fill(uint8_t* bytes, size_t size, uint8_t seed)
{
    for (size_t i = 0; i < size; i++)
    {
        bytes[i] = (uint8_t)((i * 3U + seed) % 0x70U);
    }
}

static void every_payload_comes_out_as_it_went_in(void** state)
{
    (void)state;
    for (size_t i = 0; i < sizeof codecs / sizeof codecs[0]; i++)
    {
        const codec_t* const codec = &codecs[i];
        for (uint8_t seed = 0; seed < 100U; seed++)
        {
            uint8_t in[frame_payload_max_bytes];
            uint8_t out[frame_payload_max_bytes + 1];
            fill(in, codec->size, seed);
            memset(out, guard, sizeof out);
            codec->take_and_put(in, out);
            if (memcmp(in, out, codec->size) != 0)
            {
                fail_msg("%s: a field is lost or at another place", codec->name);
            }
            if (out[codec->size] != guard)
            {
                fail_msg("%s: written beyond its size", codec->name);
            }
        }
    }
}

static void every_message_from_the_board_has_its_size_and_no_other_has_one(void** state)
{
    (void)state;
    static const int32_t unknown = -1;
    size_t known = 0;
    for (uint32_t type_id = 0; type_id < 0x400U; type_id++)
    {
        const int32_t size = protocol_telemetry_size(type_id);
        known += size >= 0 ? 1U : 0U;
        assert_true(size == unknown || (size >= 0 && size <= (int32_t)PROTOCOL_TELEMETRY_SIZE_MAX && size % 4 == 0));
    }
    assert_int_equal(known, 21);
    assert_int_equal(protocol_telemetry_size(MESSAGE_MISSION_ITEM_ID), MESSAGE_MISSION_ITEM_SIZE);
    assert_int_equal(protocol_telemetry_size(UINT32_MAX), unknown);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_payload_comes_out_as_it_went_in),
        cmocka_unit_test(every_message_from_the_board_has_its_size_and_no_other_has_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

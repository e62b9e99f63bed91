#include "support/cmocka_all.h"

#include "flight/board_sensors.h"
#include "flight/servo_outputs.h"

static const surfaces_t flight = {.elevator = 0.1F, .aileron = 0.2F, .rudder = 0.3F, .throttle = 0.4F};
static const surfaces_t hil = {.elevator = -0.1F, .aileron = -0.2F, .rudder = -0.3F, .throttle = 0.9F};

static void the_first_four_outputs_follow_the_law_in_the_order_of_the_receiver(void** state)
{
    (void)state;
    servo_outputs_t outputs;
    float positions[board_servo_count];
    servo_outputs_init(&outputs);
    servo_outputs_positions(&outputs, &flight, &hil, positions);
    assert_close(positions[rc_channel_elevator], 0.1, 1e-6);
    assert_close(positions[rc_channel_aileron], 0.2, 1e-6);
    assert_close(positions[rc_channel_rudder], 0.3, 1e-6);
    assert_close(positions[rc_channel_throttle], 0.4, 1e-6);
    assert_close(positions[4], 0.0, 0.0);
    servo_outputs_set_mode(&outputs, board_servos_hil);
    servo_outputs_positions(&outputs, &flight, &hil, positions);
    assert_close(positions[rc_channel_elevator], -0.1, 1e-6);
    assert_close(positions[rc_channel_throttle], 0.9, 1e-6);
}

static void an_output_moved_by_hand_stays_there_until_the_mode_is_chosen_anew(void** state)
{
    (void)state;
    servo_outputs_t outputs;
    float positions[board_servo_count];
    servo_outputs_init(&outputs);
    assert_true(servo_outputs_move(&outputs, rc_channel_rudder, -0.75F));
    assert_true(servo_outputs_move(&outputs, 19, 1.0F));
    servo_outputs_positions(&outputs, &flight, &hil, positions);
    assert_close(positions[rc_channel_rudder], -0.75, 0.0);
    assert_close(positions[19], 1.0, 0.0);
    servo_outputs_set_mode(&outputs, board_servos_fly_by_wire);
    servo_outputs_positions(&outputs, &flight, &hil, positions);
    assert_close(positions[rc_channel_rudder], 0.3, 1e-6);
    assert_close(positions[19], 1.0, 0.0); // no law moves this one
}

static void an_output_that_does_not_exist_or_a_position_beyond_the_stops_is_refused(void** state)
{
    (void)state;
    servo_outputs_t outputs;
    servo_outputs_init(&outputs);
    const servo_outputs_t before = outputs;
    assert_false(servo_outputs_move(&outputs, -1, 0.0F));
    assert_false(servo_outputs_move(&outputs, board_servo_count, 0.0F));
    assert_false(servo_outputs_move(&outputs, 0, 1.01F));
    assert_false(servo_outputs_move(&outputs, 0, -1.01F));
    assert_false(servo_outputs_move(&outputs, 0, NAN));
    assert_memory_equal(&outputs, &before, sizeof outputs);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_four_outputs_follow_the_law_in_the_order_of_the_receiver),
        cmocka_unit_test(an_output_moved_by_hand_stays_there_until_the_mode_is_chosen_anew),
        cmocka_unit_test(an_output_that_does_not_exist_or_a_position_beyond_the_stops_is_refused),
    };
    return cmocka_run_group_tests_name("flight.servo_outputs", tests, NULL, NULL);
}

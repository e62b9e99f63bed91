#include "support/cmocka_all.h"

#include "estimation/rotation.h"

static void angles_come_back_out_of_the_rotation_in_every_quadrant(void** state)
{
    (void)state;
    for (int yaw = 5; yaw < 360; yaw += 50)
    {
        for (int pitch = -80; pitch <= 80; pitch += 40)
        {
            for (int roll = -170; roll <= 170; roll += 68)
            {
                const euler_t angles =
                    rotation_to_euler(rotation_from_euler((euler_t){(float)yaw, (float)pitch, (float)roll}));
                assert_close(angles.yaw_deg, yaw, 0.01);
                assert_close(angles.pitch_deg, pitch, 0.01);
                assert_close(angles.roll_deg, roll, 0.01);
            }
        }
    }
}

static void with_the_nose_straight_up_the_angles_stay_finite(void** state)
{
    (void)state;
    const euler_t angles = rotation_to_euler(rotation_from_euler((euler_t){.pitch_deg = 90.0F}));
    assert_close(angles.pitch_deg, 90.0, 0.1);
    assert_true(isfinite(angles.yaw_deg) && isfinite(angles.roll_deg));
}

static void heading_east_the_nose_points_east_and_the_right_wing_south(void** state)
{
    (void)state;
    const rotation_t east = rotation_from_euler((euler_t){.yaw_deg = 90.0F});
    const vector_t nose = rotation_to_earth(east, (vector_t){.x = 1.0F});
    const vector_t wing = rotation_to_earth(east, (vector_t){.y = 1.0F});
    assert_close(nose.y, 1.0, 1e-6);
    assert_close(wing.x, -1.0, 1e-6);
}

static void with_the_right_wing_down_gravity_pulls_to_the_right(void** state)
{
    (void)state;
    const rotation_t banked = rotation_from_euler((euler_t){.yaw_deg = 123.0F, .roll_deg = 30.0F});
    const vector_t down = rotation_to_body(banked, (vector_t){.z = 1.0F});
    assert_close(down.y, 0.5, 1e-5);
    assert_close(down.z, 0.866025, 1e-5);
}

static void with_the_nose_up_gravity_pulls_back(void** state)
{
    (void)state;
    const rotation_t climbing = rotation_from_euler((euler_t){.pitch_deg = 30.0F});
    assert_close(rotation_to_body(climbing, (vector_t){.z = 1.0F}).x, -0.5, 1e-5);
}

static void there_and_back_is_the_same_vector(void** state)
{
    (void)state;
    const rotation_t rotation = rotation_from_euler((euler_t){200.0F, -35.0F, 110.0F});
    const vector_t vector = {1.0F, -2.0F, 3.0F};
    const vector_t back = rotation_to_body(rotation, rotation_to_earth(rotation, vector));
    assert_close(vector_length(vector_difference(back, vector)), 0.0, 1e-5);
}

static void rates_turn_about_the_bodys_own_axes(void** state)
{
    (void)state;
    rotation_t rotation = rotation_from_euler((euler_t){.roll_deg = 90.0F});
    for (int i = 0; i < 100; i++)
    {
        rotation = rotation_turned(rotation, (vector_t){.y = 0.01F}); // nose "up", which is a turn to the right here
    }
    const euler_t angles = rotation_to_euler(rotation);
    assert_close(angles.yaw_deg, 57.2958, 0.01);
    assert_close(angles.pitch_deg, 0.0, 0.01);
}

static void a_million_small_turns_keep_its_length(void** state)
{
    (void)state;
    rotation_t q = rotation_from_euler((euler_t){10.0F, 20.0F, 30.0F});
    for (int i = 0; i < 1000000; i++)
    {
        q = rotation_turned(q, (vector_t){1e-5F, -2e-3F, 3e-4F});
    }
    assert_close(sqrtf(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z), 1.0, 1e-5);
}

static void the_cross_product_is_right_handed(void** state)
{
    (void)state;
    const vector_t z = vector_cross((vector_t){.x = 1.0F}, (vector_t){.y = 2.0F});
    assert_close(z.z, 2.0, 1e-6);
    assert_close(vector_dot((vector_t){1.0F, 2.0F, 3.0F}, (vector_t){4.0F, -5.0F, 6.0F}), 12.0, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angles_come_back_out_of_the_rotation_in_every_quadrant),
        cmocka_unit_test(with_the_nose_straight_up_the_angles_stay_finite),
        cmocka_unit_test(heading_east_the_nose_points_east_and_the_right_wing_south),
        cmocka_unit_test(with_the_right_wing_down_gravity_pulls_to_the_right),
        cmocka_unit_test(with_the_nose_up_gravity_pulls_back),
        cmocka_unit_test(there_and_back_is_the_same_vector),
        cmocka_unit_test(rates_turn_about_the_bodys_own_axes),
        cmocka_unit_test(a_million_small_turns_keep_its_length),
        cmocka_unit_test(the_cross_product_is_right_handed),
    };
    return cmocka_run_group_tests_name("estimation.rotation", tests, NULL, NULL);
}

#include "support/cmocka_all.h"

#include <math.h>

#include "sim_noise.h"

enum
{
    draws = 100000
};

static void the_same_seed_gives_the_same_numbers(void** state)
{
    (void)state;
    sim_noise_t once;
    sim_noise_t again;
    sim_noise_t other;
    sim_noise_init(&once, 5);
    sim_noise_init(&again, 5);
    sim_noise_init(&other, 6);
    int differing = 0;
    for (int i = 0; i < 100; i++)
    {
        const float value = sim_noise_uniform(&once);
        assert_close(value, sim_noise_uniform(&again), 0.0);
        differing += fabsf(value - sim_noise_uniform(&other)) > 0.0F ? 1 : 0;
    }
    assert_true(differing > 90);
}

static void uniform_numbers_fill_their_range(void** state)
{
    (void)state;
    sim_noise_t noise;
    sim_noise_init(&noise, 0);
    double sum = 0.0;
    float smallest = 1.0F;
    float largest = -1.0F;
    for (int i = 0; i < draws; i++)
    {
        const float value = sim_noise_uniform(&noise);
        assert_true(value >= -1.0F && value < 1.0F);
        smallest = fminf(smallest, value);
        largest = fmaxf(largest, value);
        sum += (double)value;
    }
    assert_close(sum / draws, 0.0, 0.01);
    assert_true(smallest < -0.999F && largest > 0.999F);
}

static void normal_numbers_have_the_deviation_asked_for(void** state)
{
    (void)state;
    sim_noise_t noise;
    sim_noise_init(&noise, 1);
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < draws; i++)
    {
        const double value = (double)sim_noise_normal(&noise, 3.0F);
        sum += value;
        squares += value * value;
    }
    assert_close(sum / draws, 0.0, 0.05);
    assert_close(sqrt(squares / draws), 3.0, 0.05);
}

static void a_wandering_error_stays_within_its_deviation_whatever_the_step(void** state)
{
    (void)state;
    static const float steps_s[] = {0.02F, 0.2F};
    for (size_t i = 0; i < 2; i++)
    {
        sim_noise_t noise;
        sim_noise_init(&noise, 1);
        float error = 0.0F;
        double squares = 0.0;
        for (int step = 0; step < draws; step++)
        {
            sim_noise_wander(&noise, &error, 2.0F, 1.0F, steps_s[i]);
            squares += (double)(error * error);
        }
        assert_close(sqrt(squares / draws), 2.0, 0.2);
    }
}

static void a_lag_reaches_two_thirds_in_its_time(void** state)
{
    (void)state;
    float value = 0.0F;
    for (int i = 0; i < 50; i++)
    {
        value = sim_lag(value, 1.0F, 1.0F, 0.02F);
    }
    assert_close(value, 0.632, 0.001);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_seed_gives_the_same_numbers),
        cmocka_unit_test(uniform_numbers_fill_their_range),
        cmocka_unit_test(normal_numbers_have_the_deviation_asked_for),
        cmocka_unit_test(a_wandering_error_stays_within_its_deviation_whatever_the_step),
        cmocka_unit_test(a_lag_reaches_two_thirds_in_its_time),
    };
    return cmocka_run_group_tests_name("models.sim_noise", tests, NULL, NULL);
}

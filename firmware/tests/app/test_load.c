#include "support/cmocka_all.h"

#include "app/load.h"

static load_t loads_from(uint32_t now_us)
{
    load_t load = {0};
    const uint32_t none[load_tasks_max] = {0};
    for (size_t i = 1; i < load_tasks_max; i++)
    {
        load.tasks[i].processor = load_control_dsc;
    }
    load_begin(&load, none, now_us);
    return load;
}

static void each_task_counts_for_its_processor(void** state)
{
    (void)state;
    load_t load = loads_from(0);
    const uint32_t ran_us[load_tasks_max] = {200000, 100000, 50000};
    load_update(&load, ran_us, 1000000);
    assert_int_equal(load.percent[load_sensor_dsc], 20);
    assert_int_equal(load.percent[load_control_dsc], 15);
    assert_int_equal(load.tasks[0].per_mille, 200);
    assert_int_equal(load.tasks[2].per_mille, 50);
}

static void only_the_time_since_the_last_update_counts(void** state)
{
    (void)state;
    load_t load = loads_from(0);
    const uint32_t first_us[load_tasks_max] = {900000};
    const uint32_t second_us[load_tasks_max] = {1000000};
    load_update(&load, first_us, 1000000);
    assert_int_equal(load.percent[load_sensor_dsc], 90);
    load_update(&load, second_us, 2000000);
    assert_int_equal(load.percent[load_sensor_dsc], 10);
}

static void a_processor_at_work_never_shows_zero_nor_more_than_all(void** state)
{
    (void)state;
    load_t load = loads_from(0);
    const uint32_t little_us[load_tasks_max] = {1};
    load_update(&load, little_us, 1000000);
    assert_int_equal(load.percent[load_sensor_dsc], 1);
    assert_int_equal(load.percent[load_control_dsc], 0);
    const uint32_t much_us[load_tasks_max] = {2000000, 2000000};
    load_update(&load, much_us, 2000000);
    assert_int_equal(load.percent[load_sensor_dsc], 100);
    assert_int_equal(load.percent[load_control_dsc], 100);
}

static void counters_and_clock_may_wrap(void** state)
{
    (void)state;
    load_t load = loads_from(UINT32_MAX - 499999U);
    const uint32_t before_us[load_tasks_max] = {UINT32_MAX - 99999U};
    load_begin(&load, before_us, UINT32_MAX - 499999U);
    const uint32_t after_us[load_tasks_max] = {150000};
    load_update(&load, after_us, 500000);
    assert_int_equal(load.percent[load_sensor_dsc], 25);
}

static void without_time_nothing_changes(void** state)
{
    (void)state;
    load_t load = loads_from(0);
    const uint32_t ran_us[load_tasks_max] = {500000};
    load_update(&load, ran_us, 1000000);
    const uint32_t later_us[load_tasks_max] = {600000};
    load_update(&load, later_us, 1000000);
    assert_int_equal(load.percent[load_sensor_dsc], 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_task_counts_for_its_processor),
        cmocka_unit_test(only_the_time_since_the_last_update_counts),
        cmocka_unit_test(a_processor_at_work_never_shows_zero_nor_more_than_all),
        cmocka_unit_test(counters_and_clock_may_wrap),
        cmocka_unit_test(without_time_nothing_changes),
    };
    return cmocka_run_group_tests_name("app.load", tests, NULL, NULL);
}

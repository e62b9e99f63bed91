#include "support/cmocka_all.h"

#include "app/watch.h"

static watch_t watch;

static int start(void** state)
{
    (void)state;
    watch_begin(&watch, 1, 1000);
    return 0;
}

static void hear_all_but(task_id_t silent, uint32_t now_ms)
{
    for (size_t task = 0; task < task_count; task++)
    {
        if (task != (size_t)silent)
        {
            watch_hear(&watch, (task_id_t)task, now_ms);
        }
    }
}

static void tasks_that_go_on_are_well(void** state)
{
    (void)state;
    for (uint32_t now_ms = 1000; now_ms < 10000; now_ms += 100)
    {
        hear_all_but(task_count, now_ms);
        assert_int_equal(watch_find(&watch, now_ms + 50), task_count);
    }
}

static void every_task_that_hangs_is_found(void** state)
{
    (void)state;
    for (size_t task = 0; task < task_count; task++)
    {
        const uint32_t deadline_ms = task_table[task].watchdog_ms;
        if (deadline_ms == 0U)
        {
            assert_int_equal(task, task_watch); // only the supervisor itself is nobody's to wait for
            continue;
        }
        watch_begin(&watch, 1, 0);
        hear_all_but((task_id_t)task, deadline_ms);
        assert_int_equal(watch_find(&watch, deadline_ms), task_count);
        hear_all_but((task_id_t)task, deadline_ms + 1);
        assert_int_equal(watch_find(&watch, deadline_ms + 1), task);
    }
}

static void of_several_the_first_by_priority_is_named(void** state)
{
    (void)state;
    watch_hear(&watch, task_sensors, 20000);
    assert_int_equal(watch_find(&watch, 20000), task_control);
}

static void an_excuse_holds_once(void** state)
{
    (void)state;
    const uint32_t late_ms = 1000 + task_table[task_tty].watchdog_ms + 5000;
    watch_excuse(&watch, task_tty, 30000, 1000);
    hear_all_but(task_tty, late_ms);
    assert_int_equal(watch_find(&watch, late_ms), task_count);
    watch_hear(&watch, task_tty, late_ms);
    hear_all_but(task_tty, late_ms + 2000);
    assert_int_equal(watch_find(&watch, late_ms + 2000), task_tty);
}

static void patience_makes_the_deadlines_longer(void** state)
{
    (void)state;
    watch_begin(&watch, 5, 0);
    const uint32_t deadline_ms = 5 * task_table[task_sensors].watchdog_ms;
    assert_int_equal(watch_find(&watch, deadline_ms), task_count);
    assert_int_not_equal(watch_find(&watch, deadline_ms + 1), task_count);
}

static void the_clock_may_wrap(void** state)
{
    (void)state;
    watch_begin(&watch, 1, UINT32_MAX - 10);
    hear_all_but(task_count, UINT32_MAX - 10);
    assert_int_equal(watch_find(&watch, 50), task_count);
    assert_int_not_equal(watch_find(&watch, 500), task_count);
}

static void communication_yields_to_control(void** state)
{
    (void)state;
    for (size_t task = task_uart_rx; task < task_count; task++)
    {
        assert_true(task_table[task].priority < task_table[task_control].priority);
        assert_true(task_table[task].priority < task_table[task_sensors].priority);
        assert_true(task_table[task].priority > 0U); // above the idle task
    }
    assert_true(task_table[task_watch].priority > task_table[task_sensors].priority);
}

static void no_task_waits_longer_than_it_may_be_silent(void** state)
{
    (void)state;
    uint32_t stack_words = 0;
    for (size_t task = 0; task < task_count; task++)
    {
        const task_row_t* const row = &task_table[task];
        assert_true(row->watchdog_ms == 0U || row->watchdog_ms >= 2 * row->period_ms);
        assert_true(row->watchdog_ms == 0U || row->period_ms != 0U || row->watchdog_ms >= 2 * watch_wait_ms);
        stack_words += row->stack_words;
    }
    assert_int_equal(stack_words, task_stack_words);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(tasks_that_go_on_are_well, start),
        cmocka_unit_test_setup(every_task_that_hangs_is_found, start),
        cmocka_unit_test_setup(of_several_the_first_by_priority_is_named, start),
        cmocka_unit_test_setup(an_excuse_holds_once, start),
        cmocka_unit_test_setup(patience_makes_the_deadlines_longer, start),
        cmocka_unit_test_setup(the_clock_may_wrap, start),
        cmocka_unit_test_setup(communication_yields_to_control, start),
        cmocka_unit_test_setup(no_task_waits_longer_than_it_may_be_silent, start),
    };
    return cmocka_run_group_tests_name("app.watch", tests, NULL, NULL);
}

#include "support/cmocka_all.h"

#include <math.h>
#include <string.h>

#include "records/plan_record.h"
#include "support/card.h"

static card_t card;
static uint8_t room[plan_record_bytes];
static plan_t plan;

static int start(void** state)
{
    (void)state;
    card_init(&card);
    plan_clear(&plan);
    return 0;
}

/// A plan of `count` waypoints, each another one.
static void make(size_t count)
{
    plan_clear(&plan);
    plan.count = count;
    for (size_t i = 0; i < count; i++)
    {
        plan.waypoints[i] = (waypoint_t){
            .position = {27.9 + (double)i / 1024.0, -15.4 - (double)i / 1024.0},
            .altitude_ft = 500.0F + (float)i,
            .speed_kt = 50.0F,
        };
    }
}

static record_state_t save(plan_record_of_t which)
{
    const size_t taken = plan_record_take(&plan, room);
    return plan_record_save(&card.storage, which, room, sizeof room, taken);
}

static record_state_t load(plan_record_of_t which, plan_t* loaded)
{
    return plan_record_load(&card.storage, which, loaded, room, sizeof room);
}

static void plans_of_every_length_are_loaded_as_they_were_stored(void** state)
{
    (void)state;
    for (size_t count = 1; count <= plan_waypoints_max; count++)
    {
        make(count);
        assert_int_equal(save(plan_record_hil), record_whole);
        plan_t loaded;
        memset(&loaded, 0xAA, sizeof loaded);
        assert_int_equal(load(plan_record_hil, &loaded), record_whole);
        assert_memory_equal(&loaded, &plan, sizeof plan);
    }
}

static void the_two_plans_are_not_taken_for_each_other(void** state)
{
    (void)state;
    make(3);
    assert_int_equal(save(plan_record_flight), record_whole);
    plan_t loaded;
    plan_clear(&loaded);
    assert_int_equal(load(plan_record_hil, &loaded), record_absent);
    memcpy(card.files[0].name, "plan.hil", sizeof "plan.hil");
    assert_int_equal(load(plan_record_hil, &loaded), record_damaged);
    assert_int_equal(loaded.count, 0);
}

static void damage_leaves_the_plan_alone(void** state)
{
    (void)state;
    make(2);
    assert_int_equal(save(plan_record_hil), record_whole);
    make(5);
    const plan_t as_it_was = plan;
    const size_t whole = card.files[0].size;
    for (size_t byte = 0; byte < whole; byte++)
    {
        card.files[0].data[byte] ^= 0x10;
        assert_int_equal(load(plan_record_hil, &plan), record_damaged);
        card.files[0].data[byte] ^= 0x10;
    }
    for (size_t size = 0; size < whole; size++)
    {
        card.files[0].size = size;
        assert_int_equal(load(plan_record_hil, &plan), record_damaged);
    }
    assert_memory_equal(&plan, &as_it_was, sizeof plan);
}

static void a_whole_record_of_an_impossible_plan_is_damaged(void** state)
{
    (void)state;
    plan_t loaded;
    plan_clear(&loaded);
    make(4);
    plan.waypoints[3].altitude_ft = NAN;
    assert_int_equal(save(plan_record_hil), record_whole);
    assert_int_equal(load(plan_record_hil, &loaded), record_damaged);
    make(4);
    plan.waypoints[0].position.latitude_deg = 91.0;
    assert_int_equal(save(plan_record_hil), record_whole);
    assert_int_equal(load(plan_record_hil, &loaded), record_damaged);
    make(0);
    assert_int_equal(save(plan_record_hil), record_whole);
    assert_int_equal(load(plan_record_hil, &loaded), record_damaged);
    // the count and the length do not agree
    make(4);
    const size_t taken = plan_record_take(&plan, room);
    assert_int_equal(plan_record_save(&card.storage, plan_record_hil, room, sizeof room, taken - 24), record_whole);
    assert_int_equal(load(plan_record_hil, &loaded), record_damaged);
    assert_int_equal(loaded.count, 0);
}

static void a_stored_plan_begins_at_its_first_waypoint(void** state)
{
    (void)state;
    make(4);
    plan.current = 2;
    plan.holding = true;
    assert_int_equal(save(plan_record_flight), record_whole);
    plan_t loaded;
    assert_int_equal(load(plan_record_flight, &loaded), record_whole);
    assert_int_equal(loaded.current, 0);
    assert_false(loaded.holding);
    assert_false(loaded.loop);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(plans_of_every_length_are_loaded_as_they_were_stored, start),
        cmocka_unit_test_setup(the_two_plans_are_not_taken_for_each_other, start),
        cmocka_unit_test_setup(damage_leaves_the_plan_alone, start),
        cmocka_unit_test_setup(a_whole_record_of_an_impossible_plan_is_damaged, start),
        cmocka_unit_test_setup(a_stored_plan_begins_at_its_first_waypoint, start),
    };
    return cmocka_run_group_tests_name("records.plan_record", tests, NULL, NULL);
}

// The board's own store and plan upload over the real file system, with the power cut at every single write of them.
#include "support/cmocka_all.h"

#include <string.h>

#include "flight/board_card.h"
#include "support/flash.h"
#include "support/rig.h"

enum
{
    old_seed = 1,
    new_seed = 2,
    old_count = 100,
    new_count = 97
};

static flash_t flash;
static flash_t before; ///< as the flash was when the store began

/// The power comes back and the board starts with what is on the card.
static rig_t* start_again(void)
{
    flash_restart(&flash);
    rig_t* const rig = rig_start_on(&flash.volume.storage);
    rig_extend(rig);
    return rig;
}

/// Every parameter a little above its least value, by `seed`.
static void set_all(rig_t* rig, uint32_t seed)
{
    for (size_t i = 0; i < parameters_count; i++)
    {
        assert_true(tuning_set(&rig->board.tuning, i, parameter_definitions[i].minimum + (float)seed));
    }
}

static bool has_all(const rig_t* rig, uint32_t seed)
{
    for (size_t i = 0; i < parameters_count; i++)
    {
        if (rig->board.tuning.parameters.values[i] != parameter_definitions[i].minimum + (float)seed)
        {
            return false;
        }
    }
    return true;
}

static bool has_plan(const rig_t* rig, size_t plan, int32_t count, uint32_t seed)
{
    const plan_t* const held = &rig->board.plans.plan[plan];
    bool is_same = held->count == (size_t)count;
    for (int32_t i = 0; is_same && i < count; i++)
    {
        const waypoint_t wanted = rig_waypoint(seed, i);
        is_same = memcmp(&held->waypoints[i], &wanted, sizeof wanted) == 0;
    }
    return is_same;
}

/// A card with a set and both plans on it, used for a while, so that what follows meets blocks in every state.
static void fill_card(uint32_t uses)
{
    flash_init(&flash);
    rig_t* const rig = start_again();
    for (uint32_t i = 0; i <= uses; i++)
    {
        set_all(rig, old_seed + uses - i);
        assert_int_equal(rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0), command_done);
        assert_int_equal(rig_upload(rig, board_plan_flight, old_count, old_seed + uses - i), command_done);
        assert_int_equal(rig_upload(rig, board_plan_hil, old_count, old_seed + uses - i), command_done);
        assert_true(rig_keep_plans(rig));
    }
    before = flash;
}

static bool store_set(rig_t* rig)
{
    set_all(rig, new_seed);
    return rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0) == command_done;
}

static bool upload_plan(rig_t* rig)
{
    assert_int_equal(rig_upload(rig, board_plan_hil, new_count, new_seed), command_done);
    return rig_keep_plans(rig);
}

/// Do `work` with the power cut at its write number `cut`, and start the board again; whether `work` thought it was
/// done.
static bool cut_at(long cut, flash_cut_t kind, bool (*work)(rig_t* rig))
{
    flash = before;
    rig_t* rig = start_again();
    flash.writes_until_cut = cut;
    flash.cut = kind;
    const bool done = work(rig);
    assert_int_equal(flash.is_off, !done);
    (void)start_again();
    return done;
}

/// How many writes `work` needs with the power on.
static long writes_of(bool (*work)(rig_t* rig))
{
    flash = before;
    rig_t* const rig = start_again();
    const long begun = flash.writes;
    assert_true(work(rig));
    assert_int_equal(flash.written_twice, 0);
    return flash.writes - begun;
}

/// The board works as with a card that nothing happened to.
static void assert_card_works(rig_t* rig)
{
    assert_false(board_card_alarms(&rig->board.card));
    assert_true(store_set(rig));
    assert_true(upload_plan(rig));
    rig = start_again();
    assert_true(has_all(rig, new_seed));
    assert_true(has_plan(rig, board_plan_hil, new_count, new_seed));
    assert_true(has_plan(rig, board_plan_flight, old_count, old_seed));
    assert_int_equal(flash.written_twice, 0);
}

/// Cut at every write, in every way, and say how often the old and the new was found.
static void cut_everywhere(bool (*work)(rig_t* rig), bool is_plan)
{
    long cuts = 0;
    for (uint32_t uses = 0; uses < 6; uses++)
    {
        fill_card(uses);
        const long writes = writes_of(work);
        assert_true(writes > 2);
        for (long cut = 0; cut < writes; cut++)
        {
            for (size_t kind = 0; kind < flash_cut_count; kind++)
            {
                assert_false(cut_at(cut, (flash_cut_t)kind, work));
                rig_t* const rig = start_again();
                const bool is_old =
                    is_plan ? has_plan(rig, board_plan_hil, old_count, old_seed) : has_all(rig, old_seed);
                const bool is_new =
                    is_plan ? has_plan(rig, board_plan_hil, new_count, new_seed) : has_all(rig, new_seed);
                assert_true(is_old != is_new);
                // what was not being written is not touched
                assert_true(has_plan(rig, board_plan_flight, old_count, old_seed));
                assert_true(is_plan ? has_all(rig, old_seed) : has_plan(rig, board_plan_hil, old_count, old_seed));
                assert_card_works(rig);
                cuts++;
            }
        }
        assert_true(cut_at(writes, flash_cut_before, work));
    }
    assert_true(cuts > 100);
}

static void a_power_cut_in_a_store_leaves_the_old_set_or_the_new_one(void** state)
{
    (void)state;
    cut_everywhere(store_set, false);
}

static void a_power_cut_in_a_plan_s_upload_leaves_the_old_plan_or_the_new_one(void** state)
{
    (void)state;
    cut_everywhere(upload_plan, true);
}

static void a_power_cut_in_the_very_first_store_leaves_the_defaults_or_the_new_set(void** state)
{
    (void)state;
    flash_init(&flash);
    before = flash;
    const long writes = writes_of(store_set);
    parameters_t defaults;
    parameters_init(&defaults);
    for (long cut = 0; cut < writes; cut++)
    {
        for (size_t kind = 0; kind < flash_cut_count; kind++)
        {
            assert_false(cut_at(cut, (flash_cut_t)kind, store_set));
            rig_t* const rig = start_again();
            const bool is_default = memcmp(&rig->board.tuning.parameters, &defaults, sizeof defaults) == 0;
            assert_true(is_default != has_all(rig, new_seed));
            // a card that was being formatted may say so, and is usable all the same
            assert_true(store_set(rig));
            assert_true(has_all(start_again(), new_seed));
        }
    }
}

static void the_power_cut_again_and_again_never_leaves_a_mixture(void** state)
{
    (void)state;
    fill_card(0);
    uint32_t seed = old_seed;
    for (long round = 0; round < 200; round++)
    {
        rig_t* rig = start_again();
        const uint32_t next = seed % 9U + 1U;
        flash.writes_until_cut = round * 7 % 40;
        flash.cut = (flash_cut_t)(round % flash_cut_count);
        set_all(rig, next);
        (void)rig_ask(rig, COMMAND_STORE_PARAMETERS_ID, NULL, 0);
        rig = start_again();
        assert_false(board_card_alarms(&rig->board.card));
        assert_true(has_all(rig, seed) != has_all(rig, next));
        seed = has_all(rig, next) ? next : seed;
    }
    assert_true(seed != old_seed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_power_cut_in_a_store_leaves_the_old_set_or_the_new_one),
        cmocka_unit_test(a_power_cut_in_a_plan_s_upload_leaves_the_old_plan_or_the_new_one),
        cmocka_unit_test(a_power_cut_in_the_very_first_store_leaves_the_defaults_or_the_new_set),
        cmocka_unit_test(the_power_cut_again_and_again_never_leaves_a_mixture),
    };
    return cmocka_run_group_tests_name("volume.power_cut", tests, NULL, NULL);
}

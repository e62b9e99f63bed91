#include "support/cmocka_all.h"

#include <string.h>

#include "flight/board_commands.h"
#include "support/rig.h"

static void the_table_is_in_order_and_has_no_type_twice(void** state)
{
    (void)state;
    for (size_t i = 1; i < board_commands_count; i++)
    {
        assert_true(board_commands[i - 1].type_id < board_commands[i].type_id);
    }
}

static void every_command_of_the_definition_has_a_row_of_its_size(void** state)
{
    (void)state;
    size_t defined = 0;
    for (uint32_t type_id = 0; type_id < 0x200; type_id++)
    {
        const int32_t size = protocol_command_size(type_id);
        if (size < 0)
        {
            continue;
        }
        defined++;
        size_t rows = 0;
        for (size_t i = 0; i < board_commands_count; i++)
        {
            if (board_commands[i].type_id == type_id)
            {
                assert_int_equal(board_commands[i].payload_size, size);
                rows++;
            }
        }
        assert_int_equal(rows, 1);
    }
    assert_int_equal(defined, board_commands_count);
}

static void unused_types_of_deployed_boards_stay_unused(void** state)
{
    (void)state;
    rig_t* const rig = rig_start();
    rig_extend(rig);
    const uint32_t unused[] = {8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 32, 44};
    for (size_t i = 0; i < sizeof unused / sizeof unused[0]; i++)
    {
        assert_int_equal(rig_ask(rig, unused[i], NULL, 0), command_unknown);
    }
}

static void every_row_survives_a_payload_of_nothing_but_ones_and_answers_it(void** state)
{
    (void)state;
    uint8_t ones[frame_payload_max_bytes];
    memset(ones, 0xFF, sizeof ones); // NaN, -1
    for (size_t i = 0; i < board_commands_count; i++)
    {
        rig_t* const rig = rig_start();
        rig_extend(rig);
        const command_t* const row = &board_commands[i];
        const int result = rig_ask(rig, row->type_id, ones, row->payload_size);
        const bool is_silent = row->type_id == COMMAND_DO_NOTHING_ID || row->type_id == COMMAND_XPLANE_INFO_ID;
        assert_int_equal(result < 0, is_silent);
        if (!is_silent && row->payload_size > 0)
        {
            assert_int_equal(result, command_bad_value);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_is_in_order_and_has_no_type_twice),
        cmocka_unit_test(every_command_of_the_definition_has_a_row_of_its_size),
        cmocka_unit_test(unused_types_of_deployed_boards_stay_unused),
        cmocka_unit_test(every_row_survives_a_payload_of_nothing_but_ones_and_answers_it),
    };
    return cmocka_run_group_tests_name("flight.board_commands", tests, NULL, NULL);
}

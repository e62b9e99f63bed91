#include "support/cmocka_all.h"

#include "comms/command.h"

typedef struct
{
    int32_t argument;
    uint8_t first_byte;
    int runs;
} seen_t;

static command_result_t note(void* context, int32_t argument, const uint8_t* payload)
{
    seen_t* const seen = context;
    seen->argument = argument;
    seen->first_byte = payload != NULL ? payload[0] : 0;
    seen->runs++;
    return command_done;
}

static command_result_t refuse(void* context, int32_t argument, const uint8_t* payload)
{
    (void)context;
    (void)argument;
    (void)payload;
    return command_bad_state;
}

static const command_t table[] = {{3, 0, note, 30}, {5, 4, note, 50}, {9, 0, refuse, 0}, {0x100, 0, note, 256}};

static command_result_t dispatch(seen_t* seen, uint32_t type_id, const uint8_t* payload, size_t size)
{
    return command_dispatch(table, sizeof table / sizeof table[0], seen, type_id, payload, size);
}

static void the_row_of_the_type_runs_with_its_own_constant_and_the_payload(void** state)
{
    (void)state;
    seen_t seen = {0};
    const uint8_t payload[4] = {7, 0, 0, 0};
    assert_int_equal(dispatch(&seen, 5, payload, 4), command_done);
    assert_int_equal(seen.argument, 50);
    assert_int_equal(seen.first_byte, 7);
    assert_int_equal(dispatch(&seen, 0x100, NULL, 0), command_done);
    assert_int_equal(seen.argument, 256);
    assert_int_equal(dispatch(&seen, 3, NULL, 0), command_done);
    assert_int_equal(seen.runs, 3);
}

static void the_rows_own_result_comes_back(void** state)
{
    (void)state;
    assert_int_equal(dispatch(NULL, 9, NULL, 0), command_bad_state);
}

static void a_type_without_row_is_unknown(void** state)
{
    (void)state;
    seen_t seen = {0};
    const uint32_t types[] = {0, 4, 6, 0xFF, 0x101, 0xFFFFFFFFU};
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++)
    {
        assert_int_equal(dispatch(&seen, types[i], NULL, 0), command_unknown);
    }
    assert_int_equal(command_dispatch(table, 0, &seen, 3, NULL, 0), command_unknown);
    assert_int_equal(seen.runs, 0);
}

static void any_other_size_is_refused_and_nothing_runs(void** state)
{
    (void)state;
    seen_t seen = {0};
    const uint8_t payload[8] = {0};
    assert_int_equal(dispatch(&seen, 5, payload, 8), command_bad_value);
    assert_int_equal(dispatch(&seen, 5, payload, 0), command_bad_value);
    assert_int_equal(dispatch(&seen, 3, payload, 4), command_bad_value);
    assert_int_equal(seen.runs, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_row_of_the_type_runs_with_its_own_constant_and_the_payload),
        cmocka_unit_test(the_rows_own_result_comes_back),
        cmocka_unit_test(a_type_without_row_is_unknown),
        cmocka_unit_test(any_other_size_is_refused_and_nothing_runs),
    };
    return cmocka_run_group_tests_name("comms.command", tests, NULL, NULL);
}

#include "support/cmocka_all.h"

#include "params/parameters.h"

static float value_of(const parameters_t* parameters, const char* name)
{
    const int32_t index = parameters_index_of_name(name);
    assert_true(index >= 0);
    return parameters->values[index];
}

static void defaults_are_those_that_fly_the_aircraft(void** state)
{
    (void)state;
    parameters_t parameters;
    parameters_init(&parameters);
    assert_close(value_of(&parameters, "k_elev"), 1.0, 0.0);
    assert_close(value_of(&parameters, "k_int_altura"), 0.06, 1e-7);
    assert_close(value_of(&parameters, "k_div_velocidad"), 700.0, 0.0);
    assert_close(value_of(&parameters, "k_div_R_init"), 0.1, 1e-7);
    assert_true(parameters_are_valid(&parameters));
}

static void both_ends_of_every_range_are_allowed_and_nothing_beyond(void** state)
{
    (void)state;
    for (size_t i = 0; i < parameters_count; i++)
    {
        const parameter_definition_t* const definition = &parameter_definitions[i];
        parameters_t parameters;
        parameters_init(&parameters);
        assert_true(parameters_set(&parameters, i, definition->minimum));
        assert_true(parameters_set(&parameters, i, definition->maximum));
        assert_false(parameters_set(&parameters, i, definition->minimum - 0.01F));
        assert_false(parameters_set(&parameters, i, definition->maximum + 0.01F));
        assert_close(parameters.values[i], definition->maximum, 0.0);
    }
}

static void what_is_not_finite_is_refused(void** state)
{
    (void)state;
    parameters_t parameters;
    parameters_init(&parameters);
    for (size_t i = 0; i < parameters_count; i++)
    {
        assert_false(parameters_set(&parameters, i, NAN));
        assert_false(parameters_set(&parameters, i, INFINITY));
        assert_false(parameters_set(&parameters, i, -INFINITY));
    }
    assert_true(parameters_are_valid(&parameters));
    parameters.values[3] = NAN;
    assert_false(parameters_are_valid(&parameters));
}

static void the_integer_is_whole(void** state)
{
    (void)state;
    parameters_t parameters;
    parameters_init(&parameters);
    const size_t index = (size_t)parameters_index_of_name("k_div_velocidad");
    assert_false(parameters_set(&parameters, index, 700.5F));
    assert_true(parameters_set(&parameters, index, 710.0F));
}

static void every_command_from_60_to_76_sets_another_parameter(void** state)
{
    (void)state;
    bool seen[parameters_count] = {false};
    for (uint32_t type_id = 60; type_id <= 76; type_id++)
    {
        const int32_t index = parameters_index_of_command(type_id);
        assert_in_range(index, 0, parameters_count - 1);
        assert_false(seen[index]);
        seen[index] = true;
    }
    assert_int_equal(parameters_index_of_command(59), -1);
    assert_int_equal(parameters_index_of_command(77), -1);
    assert_string_equal(parameter_definitions[parameters_index_of_command(70)].name, "k_div_velocidad");
}

static void a_place_or_name_that_does_not_exist_is_refused(void** state)
{
    (void)state;
    parameters_t parameters;
    parameters_init(&parameters);
    assert_false(parameters_set(&parameters, parameters_count, 1.0F));
    assert_int_equal(parameters_index_of_name("k_nothing"), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_are_those_that_fly_the_aircraft),
        cmocka_unit_test(both_ends_of_every_range_are_allowed_and_nothing_beyond),
        cmocka_unit_test(what_is_not_finite_is_refused),
        cmocka_unit_test(the_integer_is_whole),
        cmocka_unit_test(every_command_from_60_to_76_sets_another_parameter),
        cmocka_unit_test(a_place_or_name_that_does_not_exist_is_refused),
    };
    return cmocka_run_group_tests_name("params.parameters", tests, NULL, NULL);
}

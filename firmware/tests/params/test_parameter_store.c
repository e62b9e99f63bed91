#include "support/cmocka_all.h"

#include <string.h>

#include "params/parameter_store.h"
#include "support/card.h"

/// A set that differs from the defaults, and from another `number`, in every value.
static parameters_t set_number(float number)
{
    parameters_t parameters;
    for (size_t i = 0; i < parameters_count; i++)
    {
        parameters.values[i] = 10.0F + number + (float)i;
    }
    return parameters;
}

static bool is_same(const parameters_t* a, const parameters_t* b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

static void what_was_stored_is_loaded(void** state)
{
    (void)state;
    card_t card;
    card_init(&card);
    const parameters_t stored = set_number(1.0F);
    assert_int_equal(parameter_store_save(&card.storage, &stored), storage_ok);
    parameters_t loaded;
    parameters_init(&loaded);
    assert_int_equal(parameter_store_load(&card.storage, &loaded), storage_ok);
    assert_true(is_same(&loaded, &stored));
}

static void the_newest_of_many_is_loaded(void** state)
{
    (void)state;
    card_t card;
    card_init(&card);
    for (int i = 0; i < 7; i++)
    {
        const parameters_t stored = set_number((float)i);
        assert_int_equal(parameter_store_save(&card.storage, &stored), storage_ok);
        parameters_t loaded;
        assert_int_equal(parameter_store_load(&card.storage, &loaded), storage_ok);
        assert_true(is_same(&loaded, &stored));
    }
    assert_int_equal(card.count, 2);
}

static void an_empty_card_leaves_the_parameters_alone(void** state)
{
    (void)state;
    card_t card;
    card_init(&card);
    parameters_t parameters;
    parameters_init(&parameters);
    const parameters_t before = parameters;
    assert_int_equal(parameter_store_load(&card.storage, &parameters), storage_missing);
    assert_true(is_same(&parameters, &before));
}

static void a_power_cut_at_any_byte_leaves_the_old_set_or_the_new_one(void** state)
{
    (void)state;
    for (int before = 1; before <= 3; before++)
    {
        for (long cut = 0; cut <= parameter_record_bytes; cut++)
        {
            card_t card;
            card_init(&card);
            parameters_t old = set_number(0.0F);
            for (int i = 0; i < before; i++)
            {
                old = set_number((float)i);
                assert_int_equal(parameter_store_save(&card.storage, &old), storage_ok);
            }
            card.bytes_until_cut = cut;
            const parameters_t new = set_number(20.0F);
            const bool finished = parameter_store_save(&card.storage, &new) == storage_ok;
            assert_int_equal(finished, cut == parameter_record_bytes);
            card.power_is_cut = false; // and on again
            card.bytes_until_cut = -1;
            parameters_t loaded;
            assert_int_equal(parameter_store_load(&card.storage, &loaded), storage_ok);
            assert_true(is_same(&loaded, finished ? &new : &old));
            // and the next store works
            const parameters_t next = set_number(30.0F);
            assert_int_equal(parameter_store_save(&card.storage, &next), storage_ok);
            assert_int_equal(parameter_store_load(&card.storage, &loaded), storage_ok);
            assert_true(is_same(&loaded, &next));
        }
    }
}

static void a_damaged_newest_set_falls_back_to_the_one_before(void** state)
{
    (void)state;
    for (size_t byte = 0; byte < parameter_record_bytes; byte++)
    {
        card_t card;
        card_init(&card);
        const parameters_t first = set_number(1.0F);
        const parameters_t second = set_number(2.0F);
        assert_int_equal(parameter_store_save(&card.storage, &first), storage_ok);
        assert_int_equal(parameter_store_save(&card.storage, &second), storage_ok);
        card.files[1].data[byte] ^= 0x01;
        parameters_t loaded;
        assert_int_equal(parameter_store_load(&card.storage, &loaded), storage_ok);
        assert_true(is_same(&loaded, &first));
    }
}

static void a_record_of_another_length_or_version_is_refused(void** state)
{
    (void)state;
    uint8_t bytes[parameter_record_bytes + 1] = {0};
    const parameters_t stored = set_number(3.0F);
    parameter_record_write(bytes, &stored, 9);
    parameters_t read;
    parameters_init(&read);
    uint32_t sequence = 0;
    assert_false(parameter_record_read(bytes, parameter_record_bytes + 1, &read, &sequence));
    assert_false(parameter_record_read(bytes, parameter_record_bytes - 1, &read, &sequence));
    assert_false(parameter_record_read(bytes, 0, &read, &sequence));
    assert_true(parameter_record_read(bytes, parameter_record_bytes, &read, &sequence));
    assert_int_equal(sequence, 9);
}

static void a_whole_record_with_a_value_out_of_range_is_refused(void** state)
{
    (void)state;
    uint8_t bytes[parameter_record_bytes];
    parameters_t stored = set_number(3.0F);
    stored.values[0] = 1000.0F;
    parameter_record_write(bytes, &stored, 1);
    parameters_t read;
    uint32_t sequence = 0;
    assert_false(parameter_record_read(bytes, sizeof bytes, &read, &sequence));
}

static void the_order_survives_the_counters_wrap(void** state)
{
    (void)state;
    card_t card;
    card_init(&card);
    uint8_t bytes[parameter_record_bytes];
    const parameters_t old = set_number(1.0F);
    parameter_record_write(bytes, &old, 0xFFFFFFFFU);
    assert_int_equal(card.storage.replace(&card, "params.a", bytes, sizeof bytes), storage_ok);
    const parameters_t new = set_number(2.0F);
    assert_int_equal(parameter_store_save(&card.storage, &new), storage_ok);
    parameters_t loaded;
    assert_int_equal(parameter_store_load(&card.storage, &loaded), storage_ok);
    assert_true(is_same(&loaded, &new));
}

static void a_card_that_fails_is_said_to_have_failed(void** state)
{
    (void)state;
    card_t card;
    card_init(&card);
    card.has_failed = true;
    parameters_t parameters = set_number(1.0F);
    assert_int_equal(parameter_store_save(&card.storage, &parameters), storage_failed);
    assert_int_equal(parameter_store_load(&card.storage, &parameters), storage_failed);
}

static void a_card_that_only_says_it_has_written_is_found_out(void** state)
{
    (void)state;
    card_t card;
    card_init(&card);
    const parameters_t first = set_number(1.0F);
    assert_int_equal(parameter_store_save(&card.storage, &first), storage_ok);
    card.lies = true;
    const parameters_t second = set_number(2.0F);
    assert_int_equal(parameter_store_save(&card.storage, &second), storage_failed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_stored_is_loaded),
        cmocka_unit_test(the_newest_of_many_is_loaded),
        cmocka_unit_test(an_empty_card_leaves_the_parameters_alone),
        cmocka_unit_test(a_power_cut_at_any_byte_leaves_the_old_set_or_the_new_one),
        cmocka_unit_test(a_damaged_newest_set_falls_back_to_the_one_before),
        cmocka_unit_test(a_record_of_another_length_or_version_is_refused),
        cmocka_unit_test(a_whole_record_with_a_value_out_of_range_is_refused),
        cmocka_unit_test(the_order_survives_the_counters_wrap),
        cmocka_unit_test(a_card_that_fails_is_said_to_have_failed),
        cmocka_unit_test(a_card_that_only_says_it_has_written_is_found_out),
    };
    return cmocka_run_group_tests_name("params.parameter_store", tests, NULL, NULL);
}

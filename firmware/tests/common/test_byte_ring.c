#include "support/cmocka_all.h"

#include "common/byte_ring.h"
#include "support/random.h"

enum
{
    capacity = 16
};

static void bytes_come_out_in_the_order_they_went_in(void** state)
{
    (void)state;
    uint8_t bytes[capacity];
    byte_ring_t ring;
    byte_ring_init(&ring, bytes, capacity);
    // amounts of every size, so that the ring wraps at every place
    uint32_t seed = 7;
    uint8_t next_in = 0;
    uint8_t next_out = 0;
    for (int i = 0; i < 5000; i++)
    {
        uint8_t in[capacity + 4];
        const size_t wanted = random_below(&seed, sizeof in + 1);
        for (size_t j = 0; j < wanted; j++)
        {
            in[j] = (uint8_t)(next_in + j);
        }
        const size_t room = byte_ring_room(&ring);
        const size_t put = byte_ring_put(&ring, in, wanted);
        assert_int_equal(put, wanted < room ? wanted : room);
        next_in = (uint8_t)(next_in + put);
        uint8_t out[capacity];
        const size_t taken = byte_ring_take(&ring, out, random_below(&seed, capacity + 1));
        for (size_t j = 0; j < taken; j++)
        {
            assert_int_equal(out[j], next_out);
            next_out++;
        }
    }
    assert_int_equal((uint8_t)(next_in - next_out), capacity - byte_ring_room(&ring));
}

static void a_full_ring_takes_nothing_and_an_empty_one_gives_nothing(void** state)
{
    (void)state;
    uint8_t bytes[capacity];
    byte_ring_t ring;
    byte_ring_init(&ring, bytes, capacity);
    uint8_t data[capacity] = {1, 2, 3};
    assert_int_equal(byte_ring_take(&ring, data, capacity), 0);
    assert_int_equal(byte_ring_put(&ring, data, capacity), capacity);
    assert_int_equal(byte_ring_room(&ring), 0);
    assert_int_equal(byte_ring_put(&ring, data, 1), 0);
}

static void what_was_looked_at_stays_until_it_is_skipped(void** state)
{
    (void)state;
    uint8_t bytes[capacity];
    byte_ring_t ring;
    byte_ring_init(&ring, bytes, capacity);
    const uint8_t in[] = {10, 11, 12};
    assert_int_equal(byte_ring_put(&ring, in, 3), 3);
    const uint8_t* seen = NULL;
    assert_int_equal(byte_ring_peek(&ring, &seen), 3);
    assert_int_equal(byte_ring_peek(&ring, &seen), 3);
    assert_int_equal(seen[0], 10);
    byte_ring_skip(&ring, 2);
    assert_int_equal(byte_ring_peek(&ring, &seen), 1);
    assert_int_equal(seen[0], 12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_come_out_in_the_order_they_went_in),
        cmocka_unit_test(a_full_ring_takes_nothing_and_an_empty_one_gives_nothing),
        cmocka_unit_test(what_was_looked_at_stays_until_it_is_skipped),
    };
    return cmocka_run_group_tests_name("common.byte_ring", tests, NULL, NULL);
}

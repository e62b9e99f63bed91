#include "support/cmocka_all.h"

#include "common/angle.h"
#include "estimation/magnetic_field.h"

static void the_field_is_the_published_one_of_the_model(void** state)
{
    (void)state;
    // the model's own test values at 2027.5, and places where aircraft fly, by a reference implementation
    static const struct
    {
        float latitude_deg;
        float longitude_deg;
        float north_east_down_nt[3];
    } places[] = {
        {80.0F, 0.0F, {6500.8F, 294.5F, 54869.4F}},         {0.0F, 120.0F, {39701.6F, -167.4F, -10381.8F}},
        {-80.0F, -120.0F, {6200.7F, 15730.3F, -51783.7F}},  {27.9319F, -15.3866F, {31324.3F, -1697.7F, 22335.6F}},
        {-43.53F, 172.63F, {18957.3F, 8749.1F, -53208.3F}}, {52.5F, 13.4F, {18612.4F, 1718.6F, 46511.7F}},
        {64.15F, -21.94F, {13006.6F, -2489.8F, 50904.5F}},  {-33.9F, 18.4F, {9565.4F, -4860.6F, -22503.8F}},
        {90.0F, 0.0F, {1700.4F, 593.5F, 56915.1F}},         {-90.0F, 0.0F, {14281.4F, -8891.3F, -51548.3F}},
    };
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++)
    {
        const vector_t field_nt = magnetic_field_at(places[i].latitude_deg, places[i].longitude_deg);
        assert_close(field_nt.x, places[i].north_east_down_nt[0], 0.2);
        assert_close(field_nt.y, places[i].north_east_down_nt[1], 0.2);
        assert_close(field_nt.z, places[i].north_east_down_nt[2], 0.2);
    }
}

static void the_date_line_is_no_step(void** state)
{
    (void)state;
    const vector_t west = magnetic_field_at(-17.0F, 180.0F);
    const vector_t east = magnetic_field_at(-17.0F, -180.0F);
    assert_close(west.x, east.x, 0.2);
    assert_close(west.y, east.y, 0.2);
    assert_close(west.z, east.z, 0.2);
}

static void the_declination_follows_the_aircraft(void** state)
{
    (void)state;
    magnetic_field_t magnetic = {0};
    assert_true(isnan(magnetic_field_declination_deg(&magnetic)));
    magnetic_field_move(&magnetic, 27.9319F, -15.3866F);
    assert_close(magnetic_field_declination_deg(&magnetic), -3.102, 0.001);
    magnetic_field_move(&magnetic, -33.9F, 18.4F);
    assert_close(magnetic_field_declination_deg(&magnetic), -26.937, 0.001);
}

static void a_flight_never_gets_far_from_the_declination_of_its_place(void** state)
{
    (void)state;
    magnetic_field_t magnetic = {0};
    for (int step = 0; step < 2000; step++)
    {
        const float latitude_deg = 28.0F + 0.013F * (float)step / 4.0F;
        const float longitude_deg = -15.4F - 0.013F * (float)step;
        magnetic_field_move(&magnetic, latitude_deg, longitude_deg);
        const vector_t here = magnetic_field_at(latitude_deg, longitude_deg);
        assert_close(magnetic_field_declination_deg(&magnetic), angle_to_deg(atan2f(here.y, here.x)), 0.1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_field_is_the_published_one_of_the_model),
        cmocka_unit_test(the_date_line_is_no_step),
        cmocka_unit_test(the_declination_follows_the_aircraft),
        cmocka_unit_test(a_flight_never_gets_far_from_the_declination_of_its_place),
    };
    return cmocka_run_group_tests_name("estimation.magnetic_field", tests, NULL, NULL);
}

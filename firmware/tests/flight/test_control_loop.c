#include "support/cmocka_all.h"

#include <string.h>

#include "flight/control_loop.h"
#include "flight/gains.h"
#include "support/aircraft.h"

static const float dt_s = 0.02F;

/// A loop with its aircraft; default gains, no plan, autotrim on.
typedef struct
{
    control_loop_t loop;
    control_loop_gains_t gains;
    plan_t plan;
    aircraft_t aircraft;
    surfaces_t stick;
    surfaces_t surfaces;
    int32_t source;
    bool autopilot;
    bool autotrim;
} flight_t;

static flight_t start(void)
{
    flight_t flight;
    memset(&flight, 0, sizeof flight);
    control_loop_init(&flight.loop);
    parameters_t parameters;
    parameters_init(&parameters);
    flight.gains = gains_of(&parameters);
    plan_clear(&flight.plan);
    aircraft_init(&flight.aircraft);
    flight.stick.throttle = 0.45F;
    flight.autotrim = true;
    return flight;
}

static surfaces_t step(flight_t* flight)
{
    control_loop_input_t input = aircraft_state(&flight->aircraft);
    input.stick = flight->stick;
    input.source = flight->source;
    input.autopilot = flight->autopilot;
    input.autotrim = flight->autotrim;
    flight->surfaces = control_loop_step(&flight->loop, &flight->gains, &flight->plan, &input, dt_s);
    aircraft_step(&flight->aircraft, &flight->surfaces, (double)dt_s);
    return flight->surfaces;
}

static void fly(flight_t* flight, double seconds)
{
    for (int i = 0; i < (int)(seconds / (double)dt_s); i++)
    {
        (void)step(flight);
    }
}

static float largest_difference(const surfaces_t* a, const surfaces_t* b)
{
    return fmaxf(fmaxf(fabsf(a->elevator - b->elevator), fabsf(a->aileron - b->aileron)),
                 fmaxf(fabsf(a->rudder - b->rudder), fabsf(a->throttle - b->throttle)));
}

/// Largest change from one step to the next during `seconds`, beginning with the surfaces of now.
static float roughest_step(flight_t* flight, double seconds)
{
    float roughest = 0.0F;
    for (int i = 0; i < (int)(seconds / (double)dt_s); i++)
    {
        const surfaces_t before = flight->surfaces;
        const surfaces_t after = step(flight);
        roughest = fmaxf(roughest, largest_difference(&before, &after));
    }
    return roughest;
}

static void without_a_plan_the_autopilot_holds_the_moment_it_was_switched_on(void** state)
{
    (void)state;
    flight_t flight = start();
    fly(&flight, 1.0);
    flight.autopilot = true;
    fly(&flight, 120.0);
    assert_close(flight.aircraft.altitude_ft, 1000.0, 15.0);
    assert_close(flight.aircraft.speed_kt, 55.0, 1.5);
    assert_close(flight.aircraft.track_deg, 30.0, 2.0);
    assert_close(flight.aircraft.roll_deg, 0.0, 1.0);
}

static void switching_the_autopilot_moves_no_surface_at_once(void** state)
{
    (void)state;
    flight_t flight = start();
    flight.stick.throttle = 0.8F;
    fly(&flight, 5.0);
    for (int i = 0; i < 4; i++)
    {
        flight.autopilot = !flight.autopilot;
        const surfaces_t before = flight.surfaces;
        const surfaces_t after = step(&flight);
        assert_close(largest_difference(&before, &after), 0.0, 1e-5);
        assert_true(roughest_step(&flight, 3.0) < 0.03F);
        fly(&flight, 10.0);
    }
}

static void a_deflected_stick_is_no_bump_either(void** state)
{
    (void)state;
    flight_t flight = start();
    fly(&flight, 5.0);
    flight.autopilot = true;
    fly(&flight, 20.0);
    flight.stick = (surfaces_t){0.2F, 0.25F, -0.3F, 1.0F};
    flight.autopilot = false;
    const surfaces_t before = flight.surfaces;
    const surfaces_t after = step(&flight);
    assert_close(largest_difference(&before, &after), 0.0, 1e-5);
    fly(&flight, 4.0);
    assert_close(flight.surfaces.throttle, 1.0, 0.01); // and the pilot has it all within seconds
}

static void another_source_of_the_stick_and_the_autotrim_are_no_bumps(void** state)
{
    (void)state;
    flight_t flight = start();
    fly(&flight, 30.0);
    assert_true(fabsf(flight.loop.fly_by_wire.trim) > 0.01F);
    surfaces_t before = flight.surfaces;
    flight.autotrim = false;
    surfaces_t after = step(&flight);
    assert_close(largest_difference(&before, &after), 0.0, 1e-5);
    fly(&flight, 2.0);
    before = flight.surfaces;
    flight.source = 1;
    flight.stick = (surfaces_t){0.0F, 0.1F, 0.0F, 0.9F};
    after = step(&flight);
    assert_close(largest_difference(&before, &after), 0.0, 1e-5);
}

static void the_autopilot_trims_even_where_the_pilot_wants_no_autotrim(void** state)
{
    (void)state;
    flight_t flight = start();
    flight.autotrim = false;
    flight.autopilot = true;
    fly(&flight, 120.0);
    assert_close(flight.aircraft.altitude_ft, 1000.0, 20.0);
}

static void on_the_ground_no_integral_moves(void** state)
{
    (void)state;
    flight_t flight = start();
    flight.autopilot = true;
    flight.stick.throttle = 0.9F;
    flight.aircraft.speed_kt = 5.0;
    flight.aircraft.altitude_ft = 78.0;
    (void)step(&flight);
    const control_loop_t before = flight.loop;
    control_loop_input_t input = aircraft_state(&flight.aircraft);
    input.autopilot = true;
    input.autotrim = true;
    for (int i = 0; i < 500; i++)
    {
        // the take-off run: faster and faster, at the same altitude
        input.speed_kt = 5.0F + 0.06F * (float)i;
        (void)control_loop_step(&flight.loop, &flight.gains, &flight.plan, &input, dt_s);
    }
    assert_close(flight.loop.autopilot.throttle, 0.9, 1e-6);
    assert_close(flight.loop.fly_by_wire.trim, before.fly_by_wire.trim, 0.0);
    assert_close(flight.loop.autopilot.altitude_integral_deg, before.autopilot.altitude_integral_deg, 0.0);
    input.altitude_ft = 100.0F; // and it flies
    (void)control_loop_step(&flight.loop, &flight.gains, &flight.plan, &input, dt_s);
    assert_true(flight.loop.autopilot.throttle < 0.9F);
}

static void an_aircraft_that_was_slow_in_the_air_is_not_taken_for_a_rolling_one_for_long(void** state)
{
    (void)state;
    flight_t flight = start();
    flight.autopilot = true;
    control_loop_input_t input = aircraft_state(&flight.aircraft);
    input.autopilot = true;
    input.stick.throttle = 0.5F;
    input.speed_kt = 10.0F;
    (void)control_loop_step(&flight.loop, &flight.gains, &flight.plan, &input, dt_s);
    input.speed_kt = 80.0F; // level, never leaving the altitude
    for (int i = 0; i < 22 * 50; i++)
    {
        (void)control_loop_step(&flight.loop, &flight.gains, &flight.plan, &input, dt_s);
    }
    assert_true(flight.loop.autopilot.throttle < 0.5F);
}

static void input_that_is_not_finite_holds_the_surfaces(void** state)
{
    (void)state;
    flight_t flight = start();
    flight.autopilot = true;
    fly(&flight, 10.0);
    const control_loop_t before = flight.loop;
    control_loop_input_t input = aircraft_state(&flight.aircraft);
    input.autopilot = true;
    input.pitch_deg = NAN;
    const surfaces_t surfaces = control_loop_step(&flight.loop, &flight.gains, &flight.plan, &input, dt_s);
    assert_memory_equal(&surfaces, &before.surfaces, sizeof surfaces);
    assert_memory_equal(&flight.loop, &before, sizeof before);
}

static void a_lost_position_keeps_the_last_course(void** state)
{
    (void)state;
    flight_t flight = start();
    const waypoint_t far = {{29.0, -15.3866}, 1000.0F, 55.0F};
    assert_true(plan_replace(&flight.plan, &far, 1, false));
    flight.autopilot = true;
    fly(&flight, 60.0);
    const autopilot_target_t before = flight.loop.hold;
    control_loop_input_t input = aircraft_state(&flight.aircraft);
    input.autopilot = true;
    input.autotrim = true;
    input.position.latitude_deg = (double)NAN;
    (void)control_loop_step(&flight.loop, &flight.gains, &flight.plan, &input, dt_s);
    assert_memory_equal(&flight.loop.hold, &before, sizeof before);
}

static void a_plan_is_flown_to_its_end_and_the_last_waypoint_circled(void** state)
{
    (void)state;
    flight_t flight = start();
    const waypoint_t waypoints[] = {
        {{27.9515, -15.3741}, 1100.0F, 55.0F},
        {{27.9503, -15.3573}, 1200.0F, 60.0F},
        {{27.9239, -15.3707}, 1000.0F, 55.0F},
    };
    assert_true(plan_replace(&flight.plan, waypoints, 3, false));
    flight.aircraft.wind_east_kt = 12.0;
    flight.autopilot = true;
    fly(&flight, 400.0);
    assert_true(flight.plan.holding);
    double nearest_m = 1e9;
    double farthest_m = 0.0;
    for (int i = 0; i < 6000; i++)
    {
        (void)step(&flight);
        const position_t at = {flight.aircraft.latitude_deg, flight.aircraft.longitude_deg};
        const double distance_m = (double)geodesy_distance_m(&at, &waypoints[2].position);
        nearest_m = fmin(nearest_m, distance_m);
        farthest_m = fmax(farthest_m, distance_m);
    }
    assert_true(nearest_m > 80.0);
    assert_true(farthest_m < 500.0);
    assert_close(flight.aircraft.altitude_ft, 1000.0, 40.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_plan_the_autopilot_holds_the_moment_it_was_switched_on),
        cmocka_unit_test(switching_the_autopilot_moves_no_surface_at_once),
        cmocka_unit_test(a_deflected_stick_is_no_bump_either),
        cmocka_unit_test(another_source_of_the_stick_and_the_autotrim_are_no_bumps),
        cmocka_unit_test(the_autopilot_trims_even_where_the_pilot_wants_no_autotrim),
        cmocka_unit_test(on_the_ground_no_integral_moves),
        cmocka_unit_test(an_aircraft_that_was_slow_in_the_air_is_not_taken_for_a_rolling_one_for_long),
        cmocka_unit_test(input_that_is_not_finite_holds_the_surfaces),
        cmocka_unit_test(a_lost_position_keeps_the_last_course),
        cmocka_unit_test(a_plan_is_flown_to_its_end_and_the_last_waypoint_circled),
    };
    return cmocka_run_group_tests_name("flight.control_loop", tests, NULL, NULL);
}

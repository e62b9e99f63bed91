#include "support/cmocka_all.h"

#include <string.h>

#include "flight/control_loop.h"
#include "flight/gains.h"
#include "support/aircraft.h"
#include "support/random.h"

static const float dt_s = 0.02F;

static const waypoint_t circuit[] = {
    {{27.9515, -15.3741}, 1100.0F, 55.0F},
    {{27.9503, -15.3573}, 1200.0F, 60.0F},
    {{27.9239, -15.3707}, 1000.0F, 55.0F},
    {{27.9240, -15.3900}, 900.0F, 50.0F},
};

/// An aircraft under the line law, its autopilot on.
typedef struct
{
    control_loop_t loop;
    control_loop_gains_t gains;
    plan_t plan;
    aircraft_t aircraft;
    surfaces_t surfaces;
    bool autopilot;
} flight_t;

static flight_t start(void)
{
    flight_t flight;
    memset(&flight, 0, sizeof flight);
    control_loop_init(&flight.loop);
    parameters_t parameters;
    parameters_init(&parameters);
    flight.gains = gains_of(&parameters);
    flight.gains.law = guidance_law_line;
    plan_clear(&flight.plan);
    aircraft_init(&flight.aircraft);
    flight.autopilot = true;
    return flight;
}

static surfaces_t step(flight_t* flight)
{
    control_loop_input_t input = aircraft_state(&flight->aircraft);
    input.stick.throttle = 0.45F;
    input.autopilot = flight->autopilot;
    input.autotrim = true;
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

static void a_cross_wind_pushes_it_off_no_leg(void** state)
{
    (void)state;
    flight_t flight = start();
    const waypoint_t far = {{28.2, -15.3866}, 1100.0F, 55.0F};
    assert_true(plan_replace(&flight.plan, &far, 1, false));
    flight.aircraft.wind_east_kt = 25.0;
    fly(&flight, 40.0);
    double largest_m = 0.0;
    for (int i = 0; i < 3000; i++)
    {
        (void)step(&flight);
        const position_t at = {flight.aircraft.latitude_deg, flight.aircraft.longitude_deg};
        largest_m = fmax(largest_m, fabs((double)leg_place(&flight.loop.line.legs.leg, &at).right_m));
    }
    assert_true(largest_m < 3.0);
    assert_close(flight.aircraft.altitude_ft, 1100.0, 5.0);
    assert_close(flight.aircraft.speed_kt, 55.0, 1.0);
    assert_close(hypot((double)flight.loop.line.legs.wind.east_m_s, 0.0), 12.86, 2.0);
}

static void a_circuit_is_captured_whole_and_its_end_circled(void** state)
{
    (void)state;
    flight_t flight = start();
    assert_true(plan_replace(&flight.plan, circuit, 4, false));
    flight.aircraft.wind_east_kt = 15.0;
    fly(&flight, 400.0);
    assert_int_equal(flight.loop.line.legs.captured, 4);
    assert_int_equal(flight.loop.line.legs.missed, 0);
    assert_true(flight.plan.holding);
    for (int i = 0; i < 3000; i++)
    {
        (void)step(&flight);
        const position_t at = {flight.aircraft.latitude_deg, flight.aircraft.longitude_deg};
        assert_close(geodesy_distance_m(&at, &circuit[3].position), 245.0, 60.0);
    }
    assert_close(flight.aircraft.altitude_ft, 900.0, 15.0);
}

static void without_a_plan_it_holds_the_moment_it_was_switched_on(void** state)
{
    (void)state;
    flight_t flight = start();
    fly(&flight, 120.0);
    assert_close(flight.aircraft.altitude_ft, 1000.0, 5.0);
    assert_close(flight.aircraft.speed_kt, 55.0, 1.0);
    assert_close(flight.aircraft.track_deg, 30.0, 1.0);
}

static void a_lost_position_keeps_the_last_course(void** state)
{
    (void)state;
    flight_t flight = start();
    assert_true(plan_replace(&flight.plan, circuit, 4, false));
    fly(&flight, 20.0);
    const autopilot_target_t before = flight.loop.hold;
    control_loop_input_t input = aircraft_state(&flight.aircraft);
    input.autopilot = true;
    input.position.latitude_deg = (double)NAN;
    (void)control_loop_step(&flight.loop, &flight.gains, &flight.plan, &input, dt_s);
    assert_memory_equal(&flight.loop.hold, &before, sizeof before);
}

static void against_a_strong_wind_it_flies_faster_than_planned(void** state)
{
    (void)state;
    flight_t flight = start();
    const waypoint_t far = {{28.2, -15.3866}, 1000.0F, 50.0F};
    assert_true(plan_replace(&flight.plan, &far, 1, false));
    flight.aircraft.heading_deg = 0.0;
    flight.aircraft.wind_north_kt = -48.0;
    fly(&flight, 60.0);
    assert_true(flight.loop.line.is_slow);
    assert_true(flight.aircraft.speed_kt > 56.0);
}

static void the_plan_goes_on_while_the_pilot_flies(void** state)
{
    (void)state;
    flight_t flight = start();
    assert_true(plan_replace(&flight.plan, circuit, 4, false));
    fly(&flight, 20.0);
    flight.autopilot = false;
    flight.aircraft.latitude_deg = circuit[0].position.latitude_deg + 0.001;
    flight.aircraft.longitude_deg = circuit[0].position.longitude_deg + 0.001;
    fly(&flight, 1.0);
    assert_int_equal(flight.plan.current, 1);
}

/// Change one of law, plan, waypoint and bank limit, as `random` says.
static void change_something(flight_t* flight, uint32_t* random)
{
    switch (random_below(random, 4))
    {
    case 0:
        flight->gains.law = flight->gains.law == guidance_law_line ? guidance_law_bearing : guidance_law_line;
        break;
    case 1:
        assert_true(plan_replace(&flight->plan, &circuit[random_below(random, 3)], 2, random_below(random, 2) == 0));
        break;
    case 2:
        (void)plan_go_to(&flight->plan, (int32_t)random_below(random, (uint32_t)flight->plan.count));
        break;
    default:
        flight->gains.line.follow.bank_limit_deg = 20.0F + (float)random_below(random, 30);
        break;
    }
}

static void a_thousand_changes_in_flight_move_no_surface_by_a_twentieth_of_its_travel(void** state)
{
    (void)state;
    flight_t flight = start();
    assert_true(plan_replace(&flight.plan, circuit, 4, true));
    flight.aircraft.wind_east_kt = 20.0;
    fly(&flight, 5.0);
    uint32_t random = 20260731;
    for (int i = 0; i < 1000; i++)
    {
        const bool was_line = flight.gains.law == guidance_law_line;
        const surfaces_t before = flight.surfaces;
        change_something(&flight, &random);
        const surfaces_t after = step(&flight);
        // the deployed law jumps at a new waypoint, and its bytes are to stay
        if (was_line || flight.gains.law == guidance_law_line)
        {
            assert_close(after.elevator, before.elevator, 0.1);
            assert_close(after.aileron, before.aileron, 0.1);
            assert_close(after.rudder, before.rudder, 0.1);
            assert_close(after.throttle, before.throttle, 0.05);
        }
        fly(&flight, 0.02 * (1.0 + (double)random_below(&random, 150)));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cross_wind_pushes_it_off_no_leg),
        cmocka_unit_test(a_circuit_is_captured_whole_and_its_end_circled),
        cmocka_unit_test(without_a_plan_it_holds_the_moment_it_was_switched_on),
        cmocka_unit_test(a_lost_position_keeps_the_last_course),
        cmocka_unit_test(against_a_strong_wind_it_flies_faster_than_planned),
        cmocka_unit_test(the_plan_goes_on_while_the_pilot_flies),
        cmocka_unit_test(a_thousand_changes_in_flight_move_no_surface_by_a_twentieth_of_its_travel),
    };
    return cmocka_run_group_tests_name("flight.line_law", tests, NULL, NULL);
}

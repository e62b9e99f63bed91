#include "sim_air.h"

#include <math.h>
#include <string.h>

// International standard atmosphere below 11 km.
static const float sea_level_hpa = 1013.25F;
static const float air_density_kg_m3 = 1.225F;
static const float lapse_degc_m = 0.0065F;
static const float sea_level_degc = 22.0F;   ///< on a usual day on the islands
static const float board_warmth_degc = 5.0F; ///< how much the electronics warm the sensor

// Ten lithium cells of 20 Ah, as the motor of the simulated aircraft wants (37 V).
static const float cells = 10.0F;
static const float cell_empty_v = 3.5F;
static const float cell_span_v = 0.7F;
static const float battery_ohm = 0.05F;
static const float battery_as = 20.0F * 3600.0F;
static const float electronics_a = 1.2F;
static const float motor_a = 45.0F;

void sim_air_init(sim_air_t* model, uint32_t seed)
{
    memset(model, 0, sizeof *model);
    sim_noise_init(&model->noise, seed);
    model->charge = 1.0F;
}

static float pressure_hpa(float altitude_m)
{
    return sea_level_hpa * powf(1.0F - 2.25577e-5F * altitude_m, 5.25588F);
}

/// Terminal voltage after `dt_s` at this throttle. An empty battery keeps its lowest voltage.
static float discharge(sim_air_t* model, float throttle, float dt_s)
{
    const float current_a = electronics_a + motor_a * throttle * throttle;
    model->charge = fmaxf(0.0F, model->charge - current_a * dt_s / battery_as);
    return cells * (cell_empty_v + cell_span_v * model->charge) - battery_ohm * current_a;
}

void sim_air_read(sim_air_t* model, const sim_truth_t* truth, float throttle, float dt_s, message_analog_t* analog)
{
    sim_noise_t* const noise = &model->noise;
    const float dynamic_pa = 0.5F * air_density_kg_m3 * truth->airspeed_m_s * truth->airspeed_m_s;
    const float warmth_degc = sea_level_degc - lapse_degc_m * truth->altitude_m + board_warmth_degc;
    if (!model->is_settled)
    {
        model->pitot_pa = dynamic_pa;
        model->temperature_degc = warmth_degc;
        model->is_settled = true;
    }
    sim_noise_wander(noise, &model->baro_error_hpa, 0.1F, 600.0F, dt_s);
    sim_noise_wander(noise, &model->external_error_m, 1.0F, 120.0F, dt_s);
    model->pitot_pa = sim_lag(model->pitot_pa, dynamic_pa, 0.1F, dt_s);
    model->temperature_degc = sim_lag(model->temperature_degc, warmth_degc, 60.0F, dt_s);

    *analog = (message_analog_t){
        .baro_hpa = pressure_hpa(truth->altitude_m) + model->baro_error_hpa + sim_noise_normal(noise, 0.02F),
        .altitude_m = NAN, // the board computes altitude, airspeed and climb
        .altitude_external_m = truth->altitude_m + model->external_error_m + sim_noise_normal(noise, 0.1F),
        .pitot_pa = model->pitot_pa + sim_noise_normal(noise, 0.5F),
        .calibrated_airspeed_kt = NAN,
        .alpha_deg = NAN, // this board has no vanes
        .beta_deg = NAN,
        .temperature_degc = model->temperature_degc + sim_noise_normal(noise, 0.05F),
        .battery_v = discharge(model, throttle, dt_s) + sim_noise_normal(noise, 0.02F),
        .vvi_ft_min = NAN,
    };
}

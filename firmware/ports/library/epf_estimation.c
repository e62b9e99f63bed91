#include "epf_estimation.h"

#include <stdlib.h>

estimator_t* epf_estimation_new(float declination_deg)
{
    estimator_t* const estimator = malloc(sizeof *estimator);
    if (estimator != NULL)
    {
        estimator_init(estimator, declination_deg);
    }
    return estimator;
}

void epf_estimation_free(estimator_t* estimator)
{
    free(estimator);
}

void epf_estimation_step(estimator_t* estimator, const estimator_samples_t* samples, float dt_s, estimate_t* estimate)
{
    *estimate = estimator_update(estimator, samples, dt_s);
}

uint32_t epf_estimation_refused(const estimator_t* estimator, uint32_t sensor)
{
    return sensor < estimator_sensor_count ? estimator->refused[sensor] : 0U;
}

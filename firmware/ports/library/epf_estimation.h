/// The board's state estimation in the shared library, for tests in other languages. No clock: each call is one step.
#ifndef EPF_ESTIMATION_H
#define EPF_ESTIMATION_H

#include "estimation/estimator.h"

/// An estimator that has measured nothing yet; NULL without memory.
estimator_t* epf_estimation_new(void);

void epf_estimation_free(estimator_t* estimator);

/// The aircraft's place in deg, north and east positive.
void epf_estimation_locate(estimator_t* estimator, float latitude_deg, float longitude_deg);

/// One step of `dt_s` (> 0).
void epf_estimation_step(estimator_t* estimator, const estimator_samples_t* samples, float dt_s, estimate_t* estimate);

/// Number of refused samples of one sensor (an `estimator_sensor_t`).
uint32_t epf_estimation_refused(const estimator_t* estimator, uint32_t sensor);

/// The earth's magnetic field at a place: north, east and down in nT.
void epf_magnetic_field(float latitude_deg, float longitude_deg, vector_t* field_nt);

#endif

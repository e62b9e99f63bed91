/// The parameters that the station sets, and the gains of the laws that follow from them: always changed together.
#ifndef FLIGHT_TUNING_H
#define FLIGHT_TUNING_H

#include <stdbool.h>
#include <stddef.h>

#include "flight/control_loop.h"
#include "params/parameters.h"

/// Read both; change them by the functions below alone.
typedef struct
{
    parameters_t parameters;
    control_loop_gains_t gains; ///< of `parameters`, with the law and the line law's own
} tuning_t;

/// The parameters' defaults.
void tuning_init(tuning_t* tuning);

/// Set one parameter, by its place in the table. False, and nothing changed, outside of its range.
bool tuning_set(tuning_t* tuning, size_t index, float value);

/// Select how plans are flown, by the number of a `guidance_law_t`. False, and nothing changed, for another number.
bool tuning_select_law(tuning_t* tuning, int32_t law);

/// Set one gain of the line law, by its place in the table. False, and nothing changed, outside of its range.
bool tuning_set_line(tuning_t* tuning, size_t index, float value);

/// Replace the whole set by one whose values are in their ranges.
void tuning_replace(tuning_t* tuning, const parameters_t* parameters);

#endif

/// The gains that this board has beside the 17 parameters of the wire: the choice of the law, and the line law's. They
/// are numbered from 0; the numbers belong to this firmware, the names to all.
#ifndef FLIGHT_OWN_GAINS_H
#define FLIGHT_OWN_GAINS_H

#include <stdbool.h>
#include <stddef.h>

#include "flight/tuning.h"

typedef struct
{
    const char* name;
    const char* unit; ///< "1" for a plain number
    const char* group;
    const char* choices; ///< texts of the values 0, 1, ... with a bar between them; empty for a number
    const char* help;
    float minimum;
    float maximum;
    float step;
    float default_value;
} own_gain_t;

size_t own_gains_count(void);

/// What gain `index` is. False, and nothing changed, if the table ends before it.
bool own_gains_describe(size_t index, own_gain_t* gain);

/// The value of gain `index`; 0 if the table ends before it.
float own_gains_get(const tuning_t* tuning, size_t index);

/// Give `tuning` every own gain of another.
void own_gains_copy(tuning_t* tuning, const tuning_t* other);

/// Set gain `index`. False, and nothing changed, if the table ends before it, if the value is out of its range, or if
/// the value of a choice is no whole number.
bool own_gains_set(tuning_t* tuning, size_t index, float value);

#endif

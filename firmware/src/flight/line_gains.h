/// The gains of the line law: their names, units, ranges and defaults, and where the law keeps them.
#ifndef FLIGHT_LINE_GAINS_H
#define FLIGHT_LINE_GAINS_H

#include <stdbool.h>
#include <stddef.h>

#include "control/energy.h"
#include "control/line_follow.h"

typedef struct
{
    line_follow_gains_t follow;
    energy_gains_t energy;
    float roll_time_s; ///< lag of the bank, by which turns begin earlier
    float k_rudder;    ///< in place of the parameter of this name: less yaw damping bears more delay
} line_gains_t;

typedef struct
{
    const char* name;
    const char* unit;
    const char* group;
    const char* help; ///< what it does
    float default_value;
    float minimum;
    float maximum;
    float step;
    size_t offset; ///< in line_gains_t
} line_gain_definition_t;

extern const line_gain_definition_t line_gain_definitions[];
extern const size_t line_gains_count;

/// Every gain's default.
line_gains_t line_gains_default(void);

/// The gain at `index` of the table; 0 where there is none.
float line_gains_get(const line_gains_t* gains, size_t index);

/// Set the gain at `index` of the table. False, and nothing changed, outside of its range.
bool line_gains_set(line_gains_t* gains, size_t index, float value);

#endif

/// Bumpless change between laws: the jump of the surfaces is added to the new law's output as an offset and fades away.
#ifndef CONTROL_TRANSITION_H
#define CONTROL_TRANSITION_H

#include "control/surfaces.h"

typedef struct
{
    surfaces_t offset; ///< still added to the law's output
} transition_t;

/// No offset.
void transition_init(transition_t* transition);

/// The law has changed: let the next surfaces begin at `before`, although the new law wants `wanted`.
void transition_begin(transition_t* transition, const surfaces_t* before, const surfaces_t* wanted);

/// Return the law's output plus the remaining offset, in the surfaces' limits; then let the offset fade for `dt_s`.
surfaces_t transition_update(transition_t* transition, const surfaces_t* wanted, float dt_s);

#endif

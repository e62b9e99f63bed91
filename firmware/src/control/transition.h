/// Bumpless change of who commands: what the surfaces would jump by is added to the new law's output and fades away.
#ifndef CONTROL_TRANSITION_H
#define CONTROL_TRANSITION_H

#include "control/surfaces.h"

typedef struct
{
    surfaces_t offset; ///< still added to the law's output
} transition_t;

/// Nothing to fade.
void transition_init(transition_t* transition);

/// The law changed: the next surfaces shall begin where `before` was, the new law wants `wanted`.
void transition_begin(transition_t* transition, const surfaces_t* before, const surfaces_t* wanted);

/// The law's output with what is left of the offset, inside of the surfaces' limits; then fade for `dt_s`.
surfaces_t transition_update(transition_t* transition, const surfaces_t* wanted, float dt_s);

#endif

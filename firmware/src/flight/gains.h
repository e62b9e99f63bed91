/// The parameters as gains of the two laws: the one place where the names on the wire meet those of the laws.
#ifndef FLIGHT_GAINS_H
#define FLIGHT_GAINS_H

#include "flight/control_loop.h"
#include "params/parameters.h"

control_loop_gains_t gains_of(const parameters_t* parameters);

#endif

/// Converts the parameters, named as on the wire, into the gains of the deployed laws, beside the line law's defaults.
/// No other file knows both names.
#ifndef FLIGHT_GAINS_H
#define FLIGHT_GAINS_H

#include "flight/control_loop.h"
#include "params/parameters.h"

control_loop_gains_t gains_of(const parameters_t* parameters);

#endif

#include "control/surfaces.h"

#include "common/limit.h"

surfaces_t surfaces_in_limits(const surfaces_t* surfaces)
{
    return (surfaces_t){
        .elevator = limit_to(surfaces->elevator, -1.0F, 1.0F),
        .aileron = limit_to(surfaces->aileron, -1.0F, 1.0F),
        .rudder = limit_to(surfaces->rudder, -1.0F, 1.0F),
        .throttle = limit_to(surfaces->throttle, 0.0F, 1.0F),
    };
}

/// Ground speed and track of the modelled aircraft, from the commands 50 of the simulator.
///
/// Command 50 carries no time. The board's clock does not give it either: on a busy computer or under an emulator the
/// board and the simulator run at different paces, so a distance divided by the board's time is not a speed. So the
/// ground speed is the true airspeed (that is, the air is calm), and positions only give the direction of the track
/// and tell whether the aircraft moves at all.
#ifndef SIM_MOTION_H
#define SIM_MOTION_H

#include <stddef.h>
#include <stdint.h>

#include "sim_truth.h"

enum
{
    sim_motion_places = 6 ///< the track is that of the last 50 to 60 commands: about a second at 50 Hz
};

typedef struct
{
    double latitude_deg;
    double longitude_deg;
} sim_motion_place_t;

typedef struct
{
    sim_motion_place_t places[sim_motion_places]; ///< that of every tenth command, newest first
    size_t places_held;
    uint32_t told; ///< commands since the newest of these
} sim_motion_t;

/// Set `ground_speed_m_s` and `track_deg` of `truth`, whose other values are those of a command 50 that has just come
/// in. The track of an aircraft that stands does not change.
void sim_motion_follow(sim_motion_t* motion, sim_truth_t* truth);

#endif

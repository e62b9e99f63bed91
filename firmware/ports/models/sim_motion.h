/// How the modelled aircraft moves over the ground, from what the simulator tells of it in each command 50.
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
    sim_motion_place_t places[sim_motion_places]; ///< every tenth that was told, newest first
    size_t places_held;
    uint32_t told; ///< commands since the newest of these places
} sim_motion_t;

/// A command 50 came in and is in `truth`, whose `ground_speed_m_s` and `track_deg` still tell of the one before: bring
/// them up to date. While the aircraft stands, the track stays as it is.
void sim_motion_follow(sim_motion_t* motion, sim_truth_t* truth);

#endif

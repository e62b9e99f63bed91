/// The simulated aircraft's control loop: each command 50 brings the simulator's state and steps it once.
#ifndef FLIGHT_HIL_LOOP_H
#define FLIGHT_HIL_LOOP_H

#include <stdbool.h>
#include <stdint.h>

#include "comms/protocol_gen.h"
#include "flight/control_loop.h"
#include "flight/failsafe.h"
#include "flight/measurements.h"

typedef struct
{
    control_loop_t loop;
    control_source_t source; ///< RC at start, as on deployed boards
    bool autopilot;
    bool autotrim;
    float period_s;               ///< time of one step; 0: measured between the arrivals of command 50
    command_xplane_info_t newest; ///< command 50
    bool has_newest;              ///< at least one was accepted
    uint32_t arrived_ms;          ///< when the newest did
    uint32_t moved_ms;            ///< when the newest did that was no repeat
    float step_s;                 ///< time that the newest step integrated; 0 after a refused command
    uint32_t accepted;            ///< commands 50 since the start
    uint32_t refused;             ///< those with a value that is not finite, or without a valid position
    uint32_t repeated;            ///< those of an aircraft that hangs still in the air: the simulator is paused
    uint32_t jumps;               ///< those that found the aircraft elsewhere: a reset or a new start
    failsafe_t missing;           ///< only: the simulator is silent
} hil_loop_t;

/// No simulator heard yet.
void hil_loop_init(hil_loop_t* hil, float period_s);

/// With RC as control source, autopilot and autotrim are what the transmitter's switches say: take them over. With the
/// joystick, nothing changes.
void hil_loop_refresh_switches(hil_loop_t* hil, const measurements_t* measured);

/// What the loop is given: the newest command 50, and the stick of the control source.
control_loop_input_t hil_loop_input(const hil_loop_t* hil, const measurements_t* measured);

/// Whether `info` says of the aircraft in flight, bit for bit, what `before` said. Where the stick is does not matter:
/// a pilot may move it while the simulator is paused.
bool hil_loop_repeats(const command_xplane_info_t* before, const command_xplane_info_t* info);

/// Step the loop by one command 50; the new surfaces are in `hil->loop`. A repeat is answered but takes no time: in
/// a pause of the simulator nothing is integrated. After a jump the loop begins as at the board's start. False,
/// and nothing changed but the counter, for a command with a value that is not finite or without a valid position.
bool hil_loop_step(hil_loop_t* hil, const measurements_t* measured, const control_loop_gains_t* gains, plan_t* plan,
                   const command_xplane_info_t* info, uint32_t now_ms);

/// See whether commands 50 have stopped, and do then what `failsafe_table` says.
void hil_loop_supervise(hil_loop_t* hil, uint32_t now_ms);

#endif

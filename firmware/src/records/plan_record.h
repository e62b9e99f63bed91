/// An uploaded plan as a record of the card, one file for each plan of the board.
#ifndef RECORDS_PLAN_RECORD_H
#define RECORDS_PLAN_RECORD_H

#include <stddef.h>
#include <stdint.h>

#include "hal/storage.h"
#include "navigation/plan.h"
#include "records/record.h"

enum
{
    plan_record_waypoint_bytes = 24, ///< latitude, longitude (f64, deg), altitude (f32, ft), speed (f32, kt)
    plan_record_bytes = record_frame_bytes + 4 + plan_record_waypoint_bytes * plan_waypoints_max ///< the longest
};

/// Which of the board's plans.
typedef enum
{
    plan_record_flight,
    plan_record_hil
} plan_record_of_t;

/// Load the stored plan, flown from its first waypoint. Nothing is changed unless `record_whole` comes back. `room`
/// holds `capacity` bytes, of which at least `plan_record_bytes` are needed.
record_state_t plan_record_load(const storage_t* storage, plan_record_of_t which, plan_t* plan, uint8_t* room,
                                size_t capacity);

/// Copy the plan (1..100 waypoints) into `room` for `plan_record_save`; returns how many bytes it is.
size_t plan_record_take(const plan_t* plan, uint8_t* room);

/// Write the plan that was copied to the card. What is in `room` is overwritten.
record_state_t plan_record_save(const storage_t* storage, plan_record_of_t which, uint8_t* room, size_t capacity,
                                size_t taken);

#endif

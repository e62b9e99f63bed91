#include "estimation/rotation.h"

#include <math.h>

#include "common/angle.h"
#include "common/limit.h"

vector_t vector_sum(vector_t a, vector_t b)
{
    return (vector_t){a.x + b.x, a.y + b.y, a.z + b.z};
}

vector_t vector_difference(vector_t a, vector_t b)
{
    return (vector_t){a.x - b.x, a.y - b.y, a.z - b.z};
}

vector_t vector_scaled(vector_t a, float factor)
{
    return (vector_t){a.x * factor, a.y * factor, a.z * factor};
}

vector_t vector_cross(vector_t a, vector_t b)
{
    return (vector_t){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

float vector_dot(vector_t a, vector_t b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

float vector_length(vector_t a)
{
    return sqrtf(vector_dot(a, a));
}

static rotation_t product(rotation_t a, rotation_t b)
{
    return (rotation_t){
        .w = a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
        .x = a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
        .y = a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
        .z = a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
    };
}

rotation_t rotation_from_euler(euler_t angles)
{
    const float half_yaw = angle_to_rad(angles.yaw_deg) / 2.0F;
    const float half_pitch = angle_to_rad(angles.pitch_deg) / 2.0F;
    const float half_roll = angle_to_rad(angles.roll_deg) / 2.0F;
    const rotation_t yaw = {.w = cosf(half_yaw), .z = sinf(half_yaw)};
    const rotation_t pitch = {.w = cosf(half_pitch), .y = sinf(half_pitch)};
    const rotation_t roll = {.w = cosf(half_roll), .x = sinf(half_roll)};
    return product(product(yaw, pitch), roll);
}

euler_t rotation_to_euler(rotation_t q)
{
    const vector_t ahead = rotation_to_earth(q, (vector_t){.x = 1.0F});
    const vector_t down = rotation_to_body(q, (vector_t){.z = 1.0F});
    return (euler_t){
        .yaw_deg = angle_wrap_360(angle_to_deg(atan2f(ahead.y, ahead.x))),
        .pitch_deg = angle_to_deg(asinf(limit_to(-ahead.z, -1.0F, 1.0F))),
        .roll_deg = angle_to_deg(atan2f(down.y, down.z)),
    };
}

/// v + 2 w (q x v) + 2 q x (q x v): the product q v q* without the terms that are 0.
static vector_t turned(vector_t v, vector_t q, float w)
{
    const vector_t twice = vector_scaled(vector_cross(q, v), 2.0F);
    return vector_sum(vector_sum(v, vector_scaled(twice, w)), vector_cross(q, twice));
}

vector_t rotation_to_earth(rotation_t rotation, vector_t body)
{
    return turned(body, (vector_t){rotation.x, rotation.y, rotation.z}, rotation.w);
}

vector_t rotation_to_body(rotation_t rotation, vector_t earth)
{
    return turned(earth, (vector_t){-rotation.x, -rotation.y, -rotation.z}, rotation.w);
}

rotation_t rotation_turned(rotation_t rotation, vector_t angle_rad)
{
    const float angle = vector_length(angle_rad);
    // sin(angle / 2) / angle approaches a half; below this angle a float cannot tell the difference
    const float share = angle > 1e-4F ? sinf(angle / 2.0F) / angle : 0.5F;
    const vector_t axis = vector_scaled(angle_rad, share);
    const rotation_t after = product(rotation, (rotation_t){cosf(angle / 2.0F), axis.x, axis.y, axis.z});
    // rounding would slowly change the length from 1
    const float length = sqrtf(after.w * after.w + after.x * after.x + after.y * after.y + after.z * after.z);
    return (rotation_t){after.w / length, after.x / length, after.y / length, after.z / length};
}

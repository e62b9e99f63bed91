/// Vectors and the rotation between the aircraft's body and the earth.
///
/// Body axes: x ahead, y right, z down. Earth axes: x north (true), y east, z down.
#ifndef ESTIMATION_ROTATION_H
#define ESTIMATION_ROTATION_H

typedef struct
{
    float x;
    float y;
    float z;
} vector_t;

/// Unit quaternion that turns body axes into earth axes; `w` is its real part.
typedef struct
{
    float w;
    float x;
    float y;
    float z;
} rotation_t;

/// Yaw clockwise from true north, pitch nose up, roll right wing down.
typedef struct
{
    float yaw_deg;   ///< 0..360
    float pitch_deg; ///< -90..90
    float roll_deg;  ///< -180..180
} euler_t;

vector_t vector_sum(vector_t a, vector_t b);
vector_t vector_difference(vector_t a, vector_t b);
vector_t vector_scaled(vector_t a, float factor);
vector_t vector_cross(vector_t a, vector_t b);
float vector_dot(vector_t a, vector_t b);
float vector_length(vector_t a);

rotation_t rotation_from_euler(euler_t angles);
euler_t rotation_to_euler(rotation_t rotation);

/// Turn a vector from body axes into earth axes, and back.
vector_t rotation_to_earth(rotation_t rotation, vector_t body);
vector_t rotation_to_body(rotation_t rotation, vector_t earth);

/// Where the body is after turning by `angle_rad`, a small vector in body axes (rate times time).
rotation_t rotation_turned(rotation_t rotation, vector_t angle_rad);

#endif

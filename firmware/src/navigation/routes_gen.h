// Made by protocol/generator (emit_c.py). Do not edit: change protocol/definition and run `make generate`.
#ifndef ROUTES_GEN_H
#define ROUTES_GEN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define ROUTE_COUNT 4u
#define ROUTE_WAYPOINTS_MAX 20u

/// Number of a route, as board_status reports it.
typedef enum
{
    ROUTE_GANDO = 0,
    ROUTE_RUTA_ISLA = 1,
    ROUTE_ALTERNATIVA = 2,
    ROUTE_VUELO = 3,
} route_number_t;

typedef struct
{
    double latitude_deg;  ///< WGS84, + north
    double longitude_deg; ///< WGS84, + east
    float altitude_ft;    ///< above mean sea level
    float speed_kt;       ///< indicated
} route_waypoint_t;

typedef struct
{
    const char* name;      ///< identifier, for the shell
    const char* title;     ///< as people write it
    uint32_t load_command; ///< type of the command that loads it
    bool loop;             ///< after the last waypoint comes the first
    const route_waypoint_t* waypoints;
    size_t count;
} route_t;

extern const route_t routes[ROUTE_COUNT]; ///< indexed by route_number_t

#endif

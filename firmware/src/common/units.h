/// Factors between units, and standard gravity. No other file writes one of these numbers.
#ifndef COMMON_UNITS_H
#define COMMON_UNITS_H

#define M_PER_FT 0.3048F
#define M_S_PER_KT (1852.0F / 3600.0F)
#define M_S_PER_FT_MIN (M_PER_FT / 60.0F)
#define PA_PER_HPA 100.0F
#define GRAVITY_M_S2 9.80665F

#endif

/// Limits of single values.
#ifndef COMMON_LIMIT_H
#define COMMON_LIMIT_H

/// `value` limited to [minimum, maximum]. NaN gives `minimum`, so that no law can hand a NaN to a surface.
static inline float limit_to(float value, float minimum, float maximum)
{
    if (!(value > minimum))
    {
        return minimum;
    }
    return value < maximum ? value : maximum;
}

#endif

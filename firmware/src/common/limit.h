/// Limits of single values.
#ifndef COMMON_LIMIT_H
#define COMMON_LIMIT_H

/// `value` limited to [minimum, maximum]. NaN counts as 0, so that no law can hand a NaN to a surface.
static inline float limit_to(float value, float minimum, float maximum)
{
    const float number = value == value ? value : 0.0F;
    if (number < minimum)
    {
        return minimum;
    }
    return number > maximum ? maximum : number;
}

#endif

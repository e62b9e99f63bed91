/// cmocka with the headers that it wants before its own, and the comparison of numbers that the tests use.
#ifndef SUPPORT_CMOCKA_ALL_H
#define SUPPORT_CMOCKA_ALL_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

/// Fail unless `value` is within `tolerance` (absolute, unlike cmocka's own) of `expected`; NaN never is.
#define assert_close(value, expected, tolerance)                                                                       \
    assert_close_at((double)(value), (double)(expected), (double)(tolerance), #value, __FILE__, __LINE__)

static inline void assert_close_at(double value, double expected, double tolerance, const char* expression,
                                   const char* file, int line)
{
    if (!(fabs(value - expected) <= tolerance))
    {
        print_error("%s is %.9g, expected %.9g within %g\n", expression, value, expected, tolerance);
        _fail(file, line);
    }
}

#endif

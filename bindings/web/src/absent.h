/* absent.h: put before every file of the module: what wasi-libc does not declare, and fmin and fmax inline. */
#ifndef MUSLIN_ABSENT_H
#define MUSLIN_ABSENT_H

char *realpath(const char *path, char *resolved);

/* In place of calls of the C library, one a value: WebAssembly's own f64.min and f64.max answer NaN where one of the two
 * is NaN, so the compiler may not take them for fmin and fmax. */
static inline double absent_fmin(double a, double b) { return a < b || b != b ? a : b; }
static inline double absent_fmax(double a, double b) { return a > b || b != b ? a : b; }
#include <math.h>
#define fmin absent_fmin
#define fmax absent_fmax

#endif

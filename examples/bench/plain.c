/* plain.c: the plain form of plain.h, compiled with the flags of the library's kernels. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plain.h"

#define PLAIN_REAL float
#define PLAIN(name) plain32_##name
#define PLAIN_SQRT sqrtf
#include "plain_kernel.h"
#undef PLAIN_REAL
#undef PLAIN
#undef PLAIN_SQRT

#define PLAIN_REAL double
#define PLAIN(name) plain64_##name
#define PLAIN_SQRT sqrt
#include "plain_kernel.h"

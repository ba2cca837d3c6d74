/* edge_list.c: edge_list.h in float and double, compiled with the flags of the library's kernels. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "edge_list.h"

#define PLAIN_REAL float
#define PLAIN(name) plain32_##name
#define PLAIN_SQRT sqrtf
#include "edge_list_kernel.h"
#undef PLAIN_REAL
#undef PLAIN
#undef PLAIN_SQRT

#define PLAIN_REAL double
#define PLAIN(name) plain64_##name
#define PLAIN_SQRT sqrt
#include "edge_list_kernel.h"

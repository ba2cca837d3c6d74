/* cairo-pdf.h: see cairo.h. */
#include <cairo.h>

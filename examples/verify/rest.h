/* rest.h: what the cases of cloth at rest share: plain fabrics, drapes in double, and the way to rest. */
#ifndef VERIFY_REST_H
#define VERIFY_REST_H

#include "verify.h"

#define REST_PI 3.14159265358979323846
#define REST_GRAVITY 9.81

/* A fabric that is the same along warp, weft and bias, without damping. */
void rest_fabric(mus_fabric *fabric, double weight, double stretch, double shear, double bend);

/* A panel of `n` corners (n x 2) and straight edges, warp along (gx, gy). */
mus_status rest_panel(verify *v, int32_t n, const double *corners, double gx, double gy, double spacing,
                      const mus_fabric *fabric, mus_cloth **out);

/* A drape of `cloth`, which is freed (NULL: MUS_ERR_ARG), in float (32) or double (64), stepped by velocity Verlet
 * against `drag`, gravity down y. */
mus_status rest_hang(verify *v, mus_cloth *cloth, int32_t precision, double drag, double gravity, mus_drape **out);

/* Step until no node is faster than `speed`, for `seconds` at most; MUS_ERR_UNSETTLED says how fast one still is. Speed
 * 0: for all of the seconds, as float never rests quite. */
mus_status rest_settle(verify *v, mus_drape *drape, double speed, double seconds);

/* Energy of a drape [J], NaN when there is none. */
double rest_energy(const mus_drape *drape);

/* A row, or the sentence of what went wrong. */
void rest_row(verify *v, mus_status status, const char *id, const char *text, double exact, double got,
              double tolerance);

#endif

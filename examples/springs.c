/*
 * springs.c: a network of masses and springs of your own: a rope that hangs between two pins.
 *
 * 41 beads of 10 g are joined by 40 stiff springs of 5 cm. The ends are 1.6 m apart, so the rope of 2 m sags. It is
 * stepped by Runge-Kutta with a step under the proven bound until it has come to rest. A rope that cannot stretch and
 * has no links hangs in the catenary y = a cosh(x / a), whose sag is found here by bisection.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "muslin/muslin.h"

#define BEADS 41
#define LINK 0.05  /* length of a spring at rest [m] */
#define SPAN 1.6   /* between the pins [m] */
#define MASS 0.01  /* of a bead [kg] */

static mus_context *context;


/* end with one sentence when a call failed */
static void must(mus_status status)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "springs: %s: %s\n", mus_status_name(status), mus_context_error(context));
    exit(1);
}


/* sag of a catenary of length `length` between two points of one height, `span` apart */
static double catenary_sag(double length, double span)
{
    double low = 0.01, high = 100.0; /* the length falls as a rises */
    for (int i = 0; i < 200; i++) {
        const double a = 0.5 * (low + high);
        if (2 * a * sinh(span / (2 * a)) > length) low = a;
        else high = a;
    }
    return low * (cosh(span / (2 * low)) - 1);
}


int main(void)
{
    double place[3 * BEADS] = {0}, mass[BEADS], length[BEADS - 1], stiffness[BEADS - 1], dashpot[BEADS - 1];
    int32_t spring[2 * (BEADS - 1)], pin[2] = {0, BEADS - 1};
    mus_bare bare;
    mus_cloth *rope;
    mus_drape *drape;
    mus_drape_def def;
    double sag = 0.0;

    for (int i = 0; i < BEADS; i++) {
        place[3 * i] = SPAN * i / (BEADS - 1) - SPAN / 2;
        mass[i] = MASS;
    }
    for (int s = 0; s < BEADS - 1; s++) {
        spring[2 * s] = s;
        spring[2 * s + 1] = s + 1;
        length[s] = LINK;
        stiffness[s] = 20000.0; /* [N/m]: the rope's own weight stretches it by less than 0.02 % */
        dashpot[s] = 1.0;
    }
    must(mus_context_create(NULL, &context));
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = BEADS;
    bare.springs = BEADS - 1;
    bare.pins = 2;
    bare.place = place;
    bare.mass = mass;
    bare.spring = spring;
    bare.length = length;
    bare.stiffness = stiffness;
    bare.dashpot = dashpot;
    bare.pin = pin;
    must(mus_cloth_create_bare(context, &bare, &rope));

    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    def.drag = 4.0; /* [1/s] */
    must(mus_drape_create(context, rope, NULL, &def, &drape));

    /* 8 seconds; a step above the bound would be refused */
    const double step = 0.8 * mus_drape_step_bound(drape);
    printf("step above the bound: %s\n", mus_status_name(mus_drape_step(drape, 1, 2 * mus_drape_step_bound(drape))));
    while (mus_drape_time(drape) < 8.0) must(mus_drape_step(drape, 1000, step));
    for (int i = 0; i < BEADS; i++) sag = fmax(sag, -mus_drape_positions(drape)[3 * i + 1]);
    printf("sag %.3f m, of a catenary of the same length %.3f m\n", sag, catenary_sag(LINK * (BEADS - 1), SPAN));

    mus_drape_destroy(drape);
    mus_cloth_destroy(rope);
    mus_context_destroy(context);
    return 0;
}

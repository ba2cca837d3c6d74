/*
 * fabric_value.c: the values of a fabric one by one: key with unit, range, get, set, check.
 *
 * One table serves the check of a cloth, fabric files (lib/exchange) and bindings, so that no value can have two names
 * or two ranges. Ranges reach from light gauze to a coated tarpaulin, with room; steel in place of cloth is an error of
 * units.
 */
#include <stdbool.h>
#include <string.h>

#include "cloth/cloth_internal.h"
#include "cloth/fabric.h"

typedef struct fabric_value {
    const char *key, *name; /* in files, in messages */
    size_t offset;
    double least, most;
} fabric_value;

static const fabric_value fabric_values[] = {
    {"weight_kg_per_m2", "weight", offsetof(mus_fabric, weight), 1e-3, 10.0},
    {"stretch_warp_N_per_m", "warp stretch", offsetof(mus_fabric, stretch), 1e-3, 1e7},
    {"stretch_weft_N_per_m", "weft stretch", offsetof(mus_fabric, stretch) + sizeof(double), 1e-3, 1e7},
    {"shear_N_per_m", "shear", offsetof(mus_fabric, shear), 0.0, 1e7},
    {"bend_warp_N_m", "warp bend", offsetof(mus_fabric, bend), 0.0, 1.0},
    {"bend_weft_N_m", "weft bend", offsetof(mus_fabric, bend) + sizeof(double), 0.0, 1.0},
    {"bend_bias_N_m", "bias bend", offsetof(mus_fabric, bend) + 2 * sizeof(double), 0.0, 1.0},
    {"damping_ratio", "damping", offsetof(mus_fabric, damping), 0.0, 1.0},
    {"friction_coefficient", "friction", offsetof(mus_fabric, friction), 0.0, 100.0},
    {"thickness_m", "thickness", offsetof(mus_fabric, thickness), 0.0, 0.1},
    {"bend_hysteresis_N", "bend hysteresis", offsetof(mus_fabric, bend_hysteresis), 0.0, 1.0},
    {"contraction_ratio", "contraction", offsetof(mus_fabric, contraction), 0.0, 1.0},
};

enum { FABRIC_VALUE_COUNT = sizeof fabric_values / sizeof *fabric_values };


int32_t mus_fabric_value_count(void)
{
    return FABRIC_VALUE_COUNT;
}


const char *mus_fabric_value_key(int32_t value)
{
    return value >= 0 && value < FABRIC_VALUE_COUNT ? fabric_values[value].key : NULL;
}


/* whether the size is one that a release had */
static bool fabric_known(const mus_fabric *fabric)
{
    return fabric->size == sizeof *fabric || fabric->size == MUS__FABRIC_FIRST;
}


mus_status mus_fabric_get(const mus_fabric *fabric, int32_t value, double *out)
{
    if (fabric == NULL || out == NULL || value < 0 || value >= FABRIC_VALUE_COUNT) return MUS_ERR_ARG;
    if (!fabric_known(fabric)) return MUS_ERR_VERSION;
    *out = 0.0;
    if (fabric_values[value].offset >= fabric->size) return MUS_OK;
    memcpy(out, (const char *)fabric + fabric_values[value].offset, sizeof *out);
    return MUS_OK;
}


static mus_status fabric_size(mus_context *context, const mus_fabric *fabric)
{
    if (fabric == NULL) return mus__fail(context, MUS_ERR_ARG, "fabric is NULL");
    if (fabric_known(fabric)) return MUS_OK;
    return mus__fail(context, MUS_ERR_VERSION, "fabric: size %zu, this library knows %zu; use mus_fabric_init",
                     fabric->size, sizeof *fabric);
}


static mus_status fabric_range(mus_context *context, const fabric_value *value, double number)
{
    if (number >= value->least && number <= value->most) return MUS_OK;
    return mus__fail(context, MUS_ERR_ARG, "fabric %s %g is outside %g to %g", value->name, number, value->least,
                     value->most);
}


mus_status mus_fabric_set(mus_context *context, mus_fabric *fabric, int32_t value, double number)
{
    mus_status status = fabric_size(context, fabric);
    if (status != MUS_OK) return status;
    if (value < 0 || value >= FABRIC_VALUE_COUNT)
        return mus__fail(context, MUS_ERR_ARG, "fabric value %d is outside 0 to %d", (int)value,
                         FABRIC_VALUE_COUNT - 1);
    status = fabric_range(context, &fabric_values[value], number);
    if (status != MUS_OK) return status;
    if (fabric_values[value].offset < fabric->size)
        memcpy((char *)fabric + fabric_values[value].offset, &number, sizeof number);
    else if (number != 0.0)
        status = mus__fail(context, MUS_ERR_VERSION, "fabric %s %g: the fabric's struct is of a release without it",
                           fabric_values[value].name, number);
    return status;
}


mus_status mus_fabric_check(mus_context *context, const mus_fabric *fabric)
{
    mus_status status = fabric_size(context, fabric);
    for (int32_t v = 0; status == MUS_OK && v < FABRIC_VALUE_COUNT; v++) {
        double number = 0.0;
        mus_fabric_get(fabric, v, &number);
        status = fabric_range(context, &fabric_values[v], number);
    }
    return status;
}

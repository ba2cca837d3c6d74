/*
 * cut_pieces.c: how many pieces of a panel are cut, of which material. A drape reads none of it.
 */
#include <string.h>

#include "pattern/pattern_internal.h"

static const char *const material_names[MUS_MATERIAL_COUNT] = {"main", "lining", "interfacing", "rib", "elastic"};


const char *mus_material_name(int32_t material)
{
    return material >= 0 && material < MUS_MATERIAL_COUNT ? material_names[material] : NULL;
}


int32_t mus_material_find(const char *name)
{
    for (int32_t i = 0; name != NULL && i < MUS_MATERIAL_COUNT; i++)
        if (strcmp(name, material_names[i]) == 0) return i;
    return MUS_NONE;
}


/* MUS_ERR_ARG for an unknown panel or material */
static mus_status material_known(const mus_pattern *pattern, int32_t panel, int32_t material)
{
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status == MUS_OK && (material < 0 || material >= MUS_MATERIAL_COUNT))
        status = mus__fail(pattern->context, MUS_ERR_ARG, "panel %s: material %d, expected 0 to %d",
                           pattern->panel[panel].name, (int)material, MUS_MATERIAL_COUNT - 1);
    return status;
}


mus_status mus_pattern_set_material(mus_pattern *pattern, int32_t panel, int32_t material, int32_t count)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = material_known(pattern, panel, material);
    if (status != MUS_OK) return status;
    if (count < 0 || count > MUS__CUT_MOST)
        return mus__fail(pattern->context, MUS_ERR_ARG, "panel %s: %d pieces of %s to cut is outside 0 to %d",
                         pattern->panel[panel].name, (int)count, material_names[material], MUS__CUT_MOST);
    pattern->panel[panel].attr.cut[material] = count;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_material(const mus_pattern *pattern, int32_t panel, int32_t material, int32_t *count,
                                int32_t *mirrored)
{
    if (count != NULL) *count = 0;
    if (mirrored != NULL) *mirrored = 0;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = material_known(pattern, panel, material);
    if (status != MUS_OK) return status;
    if (count != NULL) *count = pattern->panel[panel].attr.cut[material];
    for (int32_t i = 0; i < pattern->npanel && mirrored != NULL; i++)
        if (pattern->panel[i].mirror_of == panel) *mirrored = 1;
    return MUS_OK;
}

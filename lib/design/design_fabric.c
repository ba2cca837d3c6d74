/*
 * design_fabric.c: the fabric that a design is meant for: jersey for what is drafted for a knit, else that of its
 * family, as books of patterns name it (Aldrich, Metric Pattern Cutting for Women's Wear, 2008: weights of cloth by
 * garment), from the fabrics that mus_fabric_find() knows.
 */
#include <string.h>

#include "design/design_table.h"
#include "muslin/design.h"

/* families of woven cloth; those that are not here are made in cotton */
static const struct {
    const char *family, *fabric;
} fabric_of[] = {
    {"coat", "wool"},           {"cape", "wool"},          {"waistcoat", "tropical"},   {"trousers", "tropical"},
    {"culottes", "tropical"},   {"skirt_straight", "tropical"}, {"dress_sheath", "tropical"}, {"jeans", "denim"},
    {"skirt_pleated", "wool"},  {"dress_pleated", "wool"}, {"dress_pinafore", "wool"},  {"shirt", "shirting"},
    {"dress_shirt", "shirting"}, {"shorts", "pc_twill"},   {"gown", "satin"},           {"dress_wrap", "polyester"},
    {"blouse", "polyester"},    {"blouse_collar", "polyester"}, {"jumpsuit", "polyester"}, {"harem", "polyester"},
};


const char *mus_design_fabric(int32_t design)
{
    const char *family = mus_design_family(design);
    if (family == NULL) return NULL;
    if (strstr(mus_design_words(design), "cloth=knit") != NULL) return "jersey";
    for (size_t i = 0; i < sizeof fabric_of / sizeof fabric_of[0]; i++)
        if (strcmp(family, fabric_of[i].family) == 0) return fabric_of[i].fabric;
    return "cotton";
}

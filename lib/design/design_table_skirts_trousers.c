/*
 * design_table_skirts_trousers.c: named designs: skirts and trousers. How rows and families are written:
 * design_table.h.
 */
#include "design/design_table.h"

/* ---- families: the parts of an option are named x, X, xw: name, title, words ---- */

#define SKIRT(k, K, kw, family, groups, l, L, lw) {k "_skirt_" l, family, K ", " L, "skirt" kw lw, groups},
#define SKIRTS_3(...) \
    ROW(SKIRT, __VA_ARGS__, LENGTH_MINI) ROW(SKIRT, __VA_ARGS__, LENGTH_KNEE) ROW(SKIRT, __VA_ARGS__, LENGTH_MIDI)
#define SKIRTS_4(...) SKIRTS_3(__VA_ARGS__) ROW(SKIRT, __VA_ARGS__, LENGTH_MAXI)
#define SKIRT_BANDS(k, K, kw, family) \
    {k "_skirt_contour", family, K " on a contour band, low", "skirt" kw " band=contour rise=low", W}, \
    {k "_skirt_high", family, K ", high waist, faced", "skirt" kw " band=facing rise=high", W},
#define SKIRT_ELASTIC(k, K, kw, family, l, L, lw) \
    {k "_skirt_elastic_" l, family, K " with elastic, " L, "skirt" kw lw " band=elastic", W | C},
#define SKIRTS_ELASTIC(...) ROW(SKIRT_ELASTIC, __VA_ARGS__, LENGTH_MINI) ROW(SKIRT_ELASTIC, __VA_ARGS__, LENGTH_KNEE)

#define TROUSERS_SHORTENED(g, G, gw, groups) \
    {g "_capri", "trousers", G ", capri", "trousers" gw " leg_length=capri", groups}, \
    {g "_ankle", "trousers", G ", to the ankle", "trousers" gw " leg_length=ankle", groups},
#define TROUSERS(g, G, gw, groups) {g "_trousers", "trousers", G, "trousers" gw, groups},
#define TROUSERS_HIGH(g, G, gw) {g "_trousers_high", "trousers", G ", high waist", "trousers" gw " rise=high", W},
#define TROUSERS_LOW(g, G, gw) \
    {g "_trousers_low", "trousers", G ", low waist", "trousers" gw " rise=low band=contour", W},
#define TROUSERS_ELASTIC(g, G, gw) \
    {g "_elastic_short", "shorts", G " with elastic, short", "trousers" gw " leg_length=short band=elastic", \
     W | M | C}, \
    {g "_elastic_bermuda", "shorts", G " with elastic, bermuda", "trousers" gw " leg_length=bermuda band=elastic", \
     W | M | C}, \
    {g "_elastic_full", "trousers", G " with elastic", "trousers" gw " band=elastic", W | M | C},

const mus__design_row mus__designs_lower[] = {
    /* skirts: every cut in every length that goes with it */
    ROW(SKIRT, SKIRT_STRAIGHT, "skirt_straight", W | C, LENGTH_MINI)
    ROW(SKIRT, SKIRT_STRAIGHT, "skirt_straight", W | C, LENGTH_KNEE)
    ROW(SKIRT, SKIRT_STRAIGHT, "skirt_straight", W | C, LENGTH_MIDI)
    ROW(SKIRT, SKIRT_STRAIGHT, "skirt_straight", W, LENGTH_MAXI)
    ROWS(SKIRTS_3, SKIRT_PENCIL, "skirt_straight", W)
    {"a_line_mini", "skirt_straight", "A-line mini skirt", "skirt skirt=a_line length=mini", W | C},
    ROW(SKIRT, SKIRT_A_LINE, "skirt_straight", W | C, LENGTH_KNEE)
    ROW(SKIRT, SKIRT_A_LINE, "skirt_straight", W | C, LENGTH_MIDI)
    ROW(SKIRT, SKIRT_A_LINE, "skirt_straight", W, LENGTH_MAXI)
    ROWS(SKIRTS_4, SKIRT_GORED4, "skirt_gored", W)
    ROWS(SKIRTS_4, SKIRT_GORED6, "skirt_gored", W)
    ROWS(SKIRTS_4, SKIRT_GORED8, "skirt_gored", W)
    ROWS(SKIRTS_3, SKIRT_QUARTER, "skirt_circle", W | C) ROW(SKIRT, SKIRT_QUARTER, "skirt_circle", W, LENGTH_MAXI)
    ROWS(SKIRTS_3, SKIRT_HALF, "skirt_circle", W | C) ROW(SKIRT, SKIRT_HALF, "skirt_circle", W, LENGTH_MAXI)
    ROW(SKIRT, SKIRT_HALF, "skirt_circle", W, LENGTH_HI_LOW)
    ROWS(SKIRTS_3, SKIRT_THREE_QUARTER, "skirt_circle", W | C)
    ROW(SKIRT, SKIRT_THREE_QUARTER, "skirt_circle", W, LENGTH_MAXI)
    ROW(SKIRT, SKIRT_THREE_QUARTER, "skirt_circle", W, LENGTH_HI_LOW)
    ROW(SKIRT, SKIRT_FULL, "skirt_circle", W | C, LENGTH_MINI)
    {"poodle_skirt", "skirt_circle", "Poodle skirt (full circle)", "skirt skirt=full", W | C},
    ROW(SKIRT, SKIRT_FULL, "skirt_circle", W | C, LENGTH_MIDI)
    ROW(SKIRT, SKIRT_FULL, "skirt_circle", W, LENGTH_MAXI)
    ROW(SKIRT, SKIRT_FULL, "skirt_circle", W, LENGTH_HI_LOW)
    ROW(SKIRT, SKIRT_GATHERED, "skirt_gathered", W | C, LENGTH_MINI)
    ROW(SKIRT, SKIRT_GATHERED, "skirt_gathered", W | C, LENGTH_KNEE)
    {"dirndl_skirt", "skirt_gathered", "Dirndl skirt", "skirt skirt=gathered length=midi", W | C},
    ROW(SKIRT, SKIRT_GATHERED, "skirt_gathered", W, LENGTH_MAXI)
    ROW(SKIRT, SKIRT_GATHERED, "skirt_gathered", W, LENGTH_HI_LOW)
    ROW(SKIRT, SKIRT_KNIFE, "skirt_pleated", W | C, LENGTH_MINI)
    {"kilt", "skirt_pleated", "Kilt, knife pleats", "skirt skirt=knife", W | C},
    ROW(SKIRT, SKIRT_KNIFE, "skirt_pleated", W | C, LENGTH_MIDI)
    ROW(SKIRT, SKIRT_KNIFE, "skirt_pleated", W, LENGTH_MAXI)
    ROWS(SKIRTS_3, SKIRT_BOX, "skirt_pleated", W | C) ROW(SKIRT, SKIRT_BOX, "skirt_pleated", W, LENGTH_MAXI)
    ROWS(SKIRTS_3, SKIRT_TIERED, "skirt_gathered", W | C)
    {"gypsy_skirt", "skirt_gathered", "Tiered gypsy skirt", "skirt skirt=tiered length=maxi", W},
    ROWS(SKIRTS_3, SKIRT_WRAP, "skirt_wrap", W)
    {"sarong", "skirt_wrap", "Sarong", "skirt skirt=wrap length=maxi", W},
    ROW(SKIRT, SKIRT_WRAP, "skirt_wrap", W, LENGTH_HI_LOW)
    ROW(SKIRT, SKIRT_GODET, "skirt_gored", W, LENGTH_KNEE)
    ROW(SKIRT, SKIRT_GODET, "skirt_gored", W, LENGTH_MIDI)
    ROW(SKIRT, SKIRT_GODET, "skirt_gored", W, LENGTH_MAXI)
    ROW(SKIRT, SKIRT_TRUMPET, "skirt_gored", W, LENGTH_KNEE)
    ROW(SKIRT, SKIRT_TRUMPET, "skirt_gored", W, LENGTH_MIDI)
    {"mermaid_skirt", "skirt_gored", "Mermaid skirt", "skirt skirt=trumpet length=maxi", W},

    /* bands and rises of skirts */
    ROWS(SKIRT_BANDS, SKIRT_STRAIGHT, "skirt_straight") ROWS(SKIRT_BANDS, SKIRT_PENCIL, "skirt_straight")
    ROWS(SKIRT_BANDS, SKIRT_A_LINE, "skirt_straight") ROWS(SKIRT_BANDS, SKIRT_GORED6, "skirt_gored")
    ROWS(SKIRT_BANDS, SKIRT_HALF, "skirt_circle") ROWS(SKIRT_BANDS, SKIRT_BOX, "skirt_pleated")
    ROWS(SKIRTS_ELASTIC, SKIRT_GATHERED, "skirt_gathered") ROWS(SKIRTS_ELASTIC, SKIRT_TIERED, "skirt_gathered")
    ROWS(SKIRTS_ELASTIC, SKIRT_FULL, "skirt_circle") ROWS(SKIRTS_ELASTIC, SKIRT_THREE_QUARTER, "skirt_circle")
    ROWS(SKIRTS_ELASTIC, SKIRT_HALF, "skirt_circle")
    {"denim_skirt", "skirt_straight", "Denim skirt", "skirt length=mini band=contour pocket=patch", W},
    {"tube_skirt", "skirt_straight", "Knit tube skirt", "skirt skirt=pencil cloth=knit ease=slim", W},

    /* trousers, classics by their names */
    {"chinos", "trousers", "Chinos", "trousers leg=tapered pocket=welt", W | M},
    {"jeans", "jeans", "Jeans", "trousers yoke=yoke pocket=patch ease=slim", W | M},
    {"palazzo", "trousers", "Palazzo trousers", "trousers leg=wide rise=high ease=loose", W},
    {"bell_bottoms", "jeans", "Bell bottoms", "trousers leg=flare rise=low band=contour yoke=yoke pocket=patch", W | M},
    {"joggers", "joggers", "Joggers", "trousers leg=jogger band=elastic cloth=knit", W | M | C},
    {"leggings", "leggings", "Leggings", "trousers leg=tapered leg_length=ankle band=elastic cloth=knit ease=slim", W},
    {"cycling_shorts", "leggings", "Cycling shorts",
     "trousers leg=tapered leg_length=bermuda band=elastic cloth=knit ease=slim", W},
    {"culottes", "culottes", "Culottes", "trousers leg=culotte leg_length=capri", W},
    {"pyjama_trousers", "nightwear", "Pyjama trousers", "trousers band=elastic ease=loose", W | M | C},
    {"pyjama_shorts", "nightwear", "Pyjama shorts", "trousers leg_length=short band=elastic ease=loose", W | M | C},

    /* every leg in every length that goes with it */
    {"straight_shorts", "shorts", "Shorts", "trousers leg_length=short", W | M | C},
    {"straight_bermudas", "shorts", "Bermuda shorts", "trousers leg_length=bermuda", W | M | C},
    ROWS(TROUSERS_SHORTENED, LEG_STRAIGHT, W | M | C) ROW(TROUSERS, LEG_STRAIGHT, W | M | C)
    {"tapered_shorts", "shorts", "Close shorts", "trousers leg=tapered leg_length=short", W | M | C},
    {"tapered_bermudas", "shorts", "Close bermudas", "trousers leg=tapered leg_length=bermuda", W | M | C},
    ROWS(TROUSERS_SHORTENED, LEG_TAPERED, W | M | C)
    ROWS(TROUSERS_SHORTENED, LEG_BOOTCUT, W | M) ROW(TROUSERS, LEG_BOOTCUT, W | M)
    ROWS(TROUSERS_SHORTENED, LEG_FLARE, W | M) ROW(TROUSERS, LEG_FLARE, W | M)
    {"wide_shorts", "shorts", "Wide shorts", "trousers leg=wide leg_length=short", W | M | C},
    {"wide_bermudas", "shorts", "Wide bermudas", "trousers leg=wide leg_length=bermuda", W | M | C},
    ROWS(TROUSERS_SHORTENED, LEG_WIDE, W | M | C) ROW(TROUSERS, LEG_WIDE, W | M | C)
    {"culotte_bermudas", "shorts", "Culottes to the knee", "trousers leg=culotte leg_length=bermuda", W | M},
    {"jogger_ankle", "joggers", "Joggers, to the ankle", "trousers leg=jogger leg_length=ankle", W | M | C},
    {"jogger_trousers", "joggers", "Joggers", "trousers leg=jogger", W | M | C},
    {"harem_ankle", "harem", "Harem trousers, to the ankle", "trousers leg=harem leg_length=ankle", W | M},
    {"harem_trousers", "harem", "Harem trousers", "trousers leg=harem", W | M},

    /* rises, bands and eases of trousers */
    ROW(TROUSERS_HIGH, LEG_STRAIGHT) ROW(TROUSERS_LOW, LEG_STRAIGHT) ROW(TROUSERS_HIGH, LEG_BOOTCUT)
    ROW(TROUSERS_LOW, LEG_BOOTCUT) ROW(TROUSERS_HIGH, LEG_FLARE) ROW(TROUSERS_HIGH, LEG_WIDE)
    ROW(TROUSERS_LOW, LEG_WIDE) ROW(TROUSERS_HIGH, LEG_TAPERED) ROW(TROUSERS_LOW, LEG_TAPERED)
    ROWS(TROUSERS_ELASTIC, LEG_STRAIGHT) ROWS(TROUSERS_ELASTIC, LEG_WIDE)
    {"jeans_tapered", "jeans", "Jeans, tapered", "trousers leg=tapered yoke=yoke pocket=patch ease=slim", W | M},
    {"jeans_bootcut", "jeans", "Jeans, bootcut", "trousers leg=bootcut yoke=yoke pocket=patch ease=slim", W | M},
    {"jeans_flare", "jeans", "Jeans, flare", "trousers leg=flare yoke=yoke pocket=patch ease=slim", W | M},
    {"jeans_shorts", "jeans", "Jeans shorts", "trousers leg_length=short yoke=yoke pocket=patch ease=slim", W | M},
    {"slim_trousers", "trousers", "Slim trousers", "trousers leg=tapered leg_length=ankle ease=slim", W | M},
    {"loose_trousers", "trousers", "Loose trousers", "trousers ease=loose", W | M},
    {"faced_trousers", "trousers", "Trousers without a band", "trousers leg=tapered leg_length=ankle band=facing", W},
    {"harem_elastic", "harem", "Harem trousers with elastic", "trousers leg=harem band=elastic", W | M},
    {"capri_leggings", "leggings", "Capri leggings",
     "trousers leg=tapered leg_length=capri band=elastic cloth=knit ease=slim", W},
    {"yoga_flare", "leggings", "Flared leggings", "trousers leg=flare band=elastic cloth=knit ease=slim", W},
};

const int32_t mus__designs_lower_count = (int32_t)(sizeof mus__designs_lower / sizeof mus__designs_lower[0]);

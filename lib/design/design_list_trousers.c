/*
 * design_list_trousers.c: named designs: trousers, shorts, leggings. Rows: name, family, title, words, groups.
 */
#include "design/design_list.h"

#define W MUS_GROUP_WOMEN
#define M MUS_GROUP_MEN
#define C MUS_GROUP_CHILDREN

const mus__design_row mus__designs_trousers[] = {
    /* classics by their names */
    {"chinos", "trousers", "Chinos", "trousers leg=tapered", W | M},
    {"jeans", "jeans", "Jeans", "trousers pocket=patch ease=slim", W | M},
    {"palazzo", "trousers", "Palazzo trousers", "trousers leg=wide rise=high ease=loose", W},
    {"bell_bottoms", "jeans", "Bell bottoms", "trousers leg=flare rise=low band=contour", W | M},
    {"joggers", "joggers", "Joggers", "trousers leg=jogger band=elastic cloth=knit", W | M | C},
    {"leggings", "leggings", "Leggings", "trousers leg=tapered leg_length=ankle cloth=knit ease=slim closure=none", W},
    {"cycling_shorts", "leggings", "Cycling shorts",
     "trousers leg=tapered leg_length=bermuda cloth=knit ease=slim closure=none", W},
    {"culottes", "culottes", "Culottes", "trousers leg=culotte leg_length=capri", W},
    {"pyjama_trousers", "nightwear", "Pyjama trousers", "trousers band=elastic ease=loose", W | M | C},
    {"pyjama_shorts", "nightwear", "Pyjama shorts", "trousers leg_length=short band=elastic ease=loose", W | M | C},

    /* every leg in every length that goes with it */
    {"straight_shorts", "shorts", "Shorts", "trousers leg_length=short", W | M | C},
    {"straight_bermudas", "shorts", "Bermuda shorts", "trousers leg_length=bermuda", W | M | C},
    {"straight_capri", "trousers", "Straight trousers, capri", "trousers leg_length=capri", W | M | C},
    {"straight_ankle", "trousers", "Straight trousers, to the ankle", "trousers leg_length=ankle", W | M | C},
    {"straight_trousers", "trousers", "Straight trousers", "trousers", W | M | C},
    {"tapered_shorts", "shorts", "Close shorts", "trousers leg=tapered leg_length=short", W | M | C},
    {"tapered_bermudas", "shorts", "Close bermudas", "trousers leg=tapered leg_length=bermuda", W | M | C},
    {"tapered_capri", "trousers", "Tapered trousers, capri", "trousers leg=tapered leg_length=capri", W | M | C},
    {"tapered_ankle", "trousers", "Tapered trousers, to the ankle", "trousers leg=tapered leg_length=ankle", W | M | C},
    {"bootcut_capri", "trousers", "Bootcut trousers, capri", "trousers leg=bootcut leg_length=capri", W | M},
    {"bootcut_ankle", "trousers", "Bootcut trousers, to the ankle", "trousers leg=bootcut leg_length=ankle", W | M},
    {"bootcut_trousers", "trousers", "Bootcut trousers", "trousers leg=bootcut", W | M},
    {"flare_capri", "trousers", "Flared trousers, capri", "trousers leg=flare leg_length=capri", W | M},
    {"flare_ankle", "trousers", "Flared trousers, to the ankle", "trousers leg=flare leg_length=ankle", W | M},
    {"flare_trousers", "trousers", "Flared trousers", "trousers leg=flare", W | M},
    {"wide_shorts", "shorts", "Wide shorts", "trousers leg=wide leg_length=short", W | M | C},
    {"wide_bermudas", "shorts", "Wide bermudas", "trousers leg=wide leg_length=bermuda", W | M | C},
    {"wide_capri", "trousers", "Wide trousers, capri", "trousers leg=wide leg_length=capri", W | M | C},
    {"wide_ankle", "trousers", "Wide trousers, to the ankle", "trousers leg=wide leg_length=ankle", W | M | C},
    {"wide_trousers", "trousers", "Wide trousers", "trousers leg=wide", W | M | C},
    {"culotte_bermudas", "shorts", "Culottes to the knee", "trousers leg=culotte leg_length=bermuda", W | M},
    {"jogger_ankle", "joggers", "Joggers, to the ankle", "trousers leg=jogger leg_length=ankle", W | M | C},
    {"jogger_trousers", "joggers", "Joggers", "trousers leg=jogger", W | M | C},
    {"harem_ankle", "harem", "Harem trousers, to the ankle", "trousers leg=harem leg_length=ankle", W | M},
    {"harem_trousers", "harem", "Harem trousers", "trousers leg=harem", W | M},

    /* rises, bands and eases */
    {"straight_trousers_high", "trousers", "Straight trousers, high waist", "trousers rise=high", W},
    {"straight_trousers_low", "trousers", "Straight trousers, low waist", "trousers rise=low band=contour", W},
    {"bootcut_trousers_high", "trousers", "Bootcut trousers, high waist", "trousers leg=bootcut rise=high", W},
    {"bootcut_trousers_low", "trousers", "Bootcut trousers, low waist",
     "trousers leg=bootcut rise=low band=contour", W},
    {"flare_trousers_high", "trousers", "Flared trousers, high waist", "trousers leg=flare rise=high", W},
    {"wide_trousers_high", "trousers", "Wide trousers, high waist", "trousers leg=wide rise=high", W},
    {"wide_trousers_low", "trousers", "Wide trousers, low waist", "trousers leg=wide rise=low band=contour", W},
    {"tapered_trousers_high", "trousers", "Tapered trousers, high waist", "trousers leg=tapered rise=high", W},
    {"tapered_trousers_low", "trousers", "Tapered trousers, low waist",
     "trousers leg=tapered rise=low band=contour", W},
    {"straight_elastic_short", "shorts", "Straight trousers with elastic, short",
     "trousers leg_length=short band=elastic", W | M | C},
    {"straight_elastic_bermuda", "shorts", "Straight trousers with elastic, bermuda",
     "trousers leg_length=bermuda band=elastic", W | M | C},
    {"straight_elastic_full", "trousers", "Straight trousers with elastic", "trousers band=elastic", W | M | C},
    {"wide_elastic_short", "shorts", "Wide trousers with elastic, short",
     "trousers leg=wide leg_length=short band=elastic", W | M | C},
    {"wide_elastic_bermuda", "shorts", "Wide trousers with elastic, bermuda",
     "trousers leg=wide leg_length=bermuda band=elastic", W | M | C},
    {"wide_elastic_full", "trousers", "Wide trousers with elastic", "trousers leg=wide band=elastic", W | M | C},
    {"jeans_tapered", "jeans", "Jeans, tapered", "trousers leg=tapered pocket=patch ease=slim", W | M},
    {"jeans_bootcut", "jeans", "Jeans, bootcut", "trousers leg=bootcut pocket=patch ease=slim", W | M},
    {"jeans_flare", "jeans", "Jeans, flare", "trousers leg=flare pocket=patch ease=slim", W | M},
    {"jeans_shorts", "jeans", "Jeans shorts", "trousers leg_length=short pocket=patch ease=slim", W | M},
    {"slim_trousers", "trousers", "Slim trousers", "trousers leg=tapered leg_length=ankle ease=slim", W | M},
    {"loose_trousers", "trousers", "Loose trousers", "trousers ease=loose", W | M},
    {"faced_trousers", "trousers", "Trousers without a band", "trousers leg=tapered leg_length=ankle band=facing", W},
    {"harem_elastic", "harem", "Harem trousers with elastic", "trousers leg=harem band=elastic", W | M},
    {"capri_leggings", "leggings", "Capri leggings",
     "trousers leg=tapered leg_length=capri cloth=knit ease=slim closure=none", W},
    {"yoga_flare", "leggings", "Flared leggings", "trousers leg=flare cloth=knit ease=slim closure=none", W},
};

const int32_t mus__designs_trousers_count = (int32_t)(sizeof mus__designs_trousers / sizeof mus__designs_trousers[0]);

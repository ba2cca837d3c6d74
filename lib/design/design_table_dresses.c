/*
 * design_table_dresses.c: named designs: dresses, jumpsuits, capes. How rows and families are written: design_table.h.
 */
#include "design/design_table.h"

/* ---- families: the parts of an option are named x, X, xw: name, title, words ---- */

#define DRESS(k, family, title, skirt, shape, n, N, nw, s, S, sw) \
    {k "_" n "_" s, family, title ", " N ", " S, "dress" nw sw shape skirt, W},
#define DRESSES_2(...) ROW(DRESS, __VA_ARGS__, SLEEVE_SHORT) ROW(DRESS, __VA_ARGS__, SLEEVE_LONG)
#define DRESSES_3(...) ROW(DRESS, __VA_ARGS__, SLEEVE_NONE) DRESSES_2(__VA_ARGS__)
#define DRESSES_SHORT(...) ROW(DRESS, __VA_ARGS__, SLEEVE_NONE) ROW(DRESS, __VA_ARGS__, SLEEVE_SHORT)

#define SHEATH "sheath", "dress_sheath", "Sheath dress", "", ""
#define PENCIL "pencil", "dress_sheath", "Pencil dress", " skirt=pencil", ""
#define A_LINE "a_line", "dress_a_line", "A-line dress", " skirt=a_line", ""
#define SWING "swing", "dress_flare", "Swing dress, half circle", " skirt=half", ""
#define GATHERED "gathered", "dress_gathered", "Dress with a gathered skirt", " skirt=gathered", ""
#define PLEATED "pleated", "dress_pleated", "Dress with a pleated skirt", " skirt=knife", ""
#define PRINCESS_A_LINE \
    "princess_a_line", "dress_princess", "Princess dress, a-line skirt", " skirt=a_line", " shape=princess_shoulder"
#define PRINCESS_HALF \
    "princess_half", "dress_princess", "Princess dress, half circle skirt", " skirt=half", " shape=princess_shoulder"
#define PANEL_A_LINE \
    "panel_a_line", "dress_princess", "Panel dress, a-line skirt", " skirt=a_line", " shape=princess_armhole"
#define PANEL_HALF \
    "panel_half", "dress_princess", "Panel dress, half circle skirt", " skirt=half", " shape=princess_armhole"
#define EMPIRE_A_LINE \
    "empire_a_line", "dress_empire", "Empire dress, a-line skirt", " skirt=a_line", " shape=empire"
#define EMPIRE_GATHERED \
    "empire_gathered", "dress_empire", "Empire dress, gathered skirt", " skirt=gathered", " shape=empire"

#define GOWN_HALF(n, N, nw) \
    {"gown_" n "_half", "gown", "Gown, " N ", half circle skirt", "dress" nw " skirt=half length=maxi", W},
#define GOWN_WIDE(n, N, nw) \
    {"gown_" n "_full", "gown", "Gown, " N ", full circle skirt", "dress" nw " skirt=full length=maxi", W}, \
    {"gown_" n "_gathered", "gown", "Gown, " N ", gathered skirt", "dress" nw " skirt=gathered length=maxi", W},
#define GOWN_TRUMPET(n, N, nw) \
    {"gown_" n "_trumpet", "gown", "Gown, " N ", trumpet skirt", \
     "dress" nw " shape=princess_armhole skirt=trumpet length=maxi", W},
#define GOWN_GORED(n, N, nw) \
    {"gown_" n "_gored8", "gown", "Gown, " N ", skirt of eight gores", \
     "dress" nw " shape=princess_armhole skirt=gored8 length=maxi", W},

#define DRESS_SLEEVE(s, S, sw) \
    {"a_line_dress_" s, "dress_a_line", "A-line dress, " S, "dress" sw " skirt=a_line", W},
#define DRESS_COLLAR(s, S, sw) \
    {"shirt_dress_" s, "dress_shirt", "Shirt dress, " S, "dress" sw " collar=shirt skirt=a_line", W}, \
    {"shirt_dress_flared_" s, "dress_shirt", "Shirt dress, half circle, " S, \
     "dress" sw " collar=shirt skirt=half length=midi", W}, \
    {"collar_dress_" s, "dress_shirt", "Dress with a Peter Pan collar, " S, \
     "dress" sw " collar=peter_pan closure=back skirt=gathered", W}, \
    {"knit_dress_" s, "dress_knit", "Knit dress, " S, "dress neck=v" sw " cloth=knit skirt=a_line", W},

#define CHILD(k, title, skirt, s, S, sw) \
    {"child_" k "_" s, "dress_child", "Child's dress, " title " skirt, " S, \
     "dress neck=scoop" sw " shape=boxy closure=back" skirt, C},
#define CHILDREN(...) \
    ROW(CHILD, __VA_ARGS__, SLEEVE_NONE) ROW(CHILD, __VA_ARGS__, SLEEVE_SHORT) ROW(CHILD, __VA_ARGS__, SLEEVE_LONG)

/* ---- families of jumpsuits and capes ---- */

#define JUMPSUITS(n, N, nw) \
    {"jumpsuit_" n "_wide", "jumpsuit", "Jumpsuit, " N ", wide trousers", "jumpsuit" nw " leg=wide", W}, \
    {"jumpsuit_" n "_tapered", "jumpsuit", "Jumpsuit, " N ", tapered trousers", "jumpsuit" nw " leg=tapered", W}, \
    {"jumpsuit_" n "_flare", "jumpsuit", "Jumpsuit, " N ", flared trousers", "jumpsuit" nw " leg=flare", W}, \
    {"jumpsuit_" n "_culotte", "jumpsuit", "Jumpsuit, " N ", culottes", \
     "jumpsuit" nw " leg=culotte leg_length=capri", W},
#define JUMPSUITS_SHIRT(s, S, sw) \
    {"jumpsuit_shirt_" s, "jumpsuit", "Shirt jumpsuit, " S, "jumpsuit" sw " collar=shirt leg=tapered", W}, \
    {"overall_" s, "jumpsuit", "Overall, " S, "jumpsuit" sw " collar=shirt shape=boxy ease=loose", W | M},
#define ROMPERS(n, N, nw) \
    {"romper_" n "_straight", "romper", "Romper, " N ", straight legs", "jumpsuit" nw " leg_length=short", W}, \
    {"romper_" n "_wide", "romper", "Romper, " N ", wide legs", "jumpsuit" nw " leg=wide leg_length=short", W},
#define CAPES(l, title, lw) \
    {"cape_" l, "cape", "Cape, " title, "cape" lw " closure=front collar=mandarin", W | M | C}, \
    {"cape_hood_" l, "cape", "Hooded cape, " title, "cape" lw " closure=front collar=hood", W | M | C},

const mus__design_row mus__designs_dress[] = {
    /* dresses, classics by their names */
    {"sheath", "dress_sheath", "Sheath dress", "dress", W},
    {"shift", "dress_shift", "Shift dress", "dress shape=boxy skirt=a_line closure=back", W | C},
    {"princess_dress", "dress_princess", "Princess dress", "dress shape=princess_shoulder skirt=gored6", W},
    {"fit_and_flare", "dress_flare", "Fit and flare dress", "dress neck=scoop skirt=half", W},
    {"wrap_dress", "dress_wrap", "Wrap dress", "dress neck=deep_v sleeve=three_quarter skirt=wrap closure=wrap", W},
    {"shirt_dress", "dress_shirt", "Shirt dress", "dress sleeve=long collar=shirt skirt=a_line cuff=cuff", W},
    {"regency", "dress_empire", "Empire dress (regency)",
     "dress neck=square sleeve=puff shape=empire skirt=gathered length=maxi", W},
    {"pinafore", "dress_pinafore", "Pinafore", "dress neck=square skirt=a_line pocket=patch", W | C},
    {"tent_dress", "dress_shift", "Tent dress", "dress shape=boxy skirt=gathered ease=loose closure=back", W | C},
    {"tea_dress", "dress_flare", "Tea dress", "dress neck=v sleeve=short shape=waist skirt=gored6 length=midi", W},
    {"qipao", "dress_sheath", "Qipao", "dress sleeve=cap collar=mandarin skirt=pencil length=midi closure=back", W},
    {"baby_doll", "dress_empire", "Baby doll",
     "dress neck=scoop sleeve=puff shape=empire skirt=gathered length=mini", W},
    {"maxi_halter", "gown", "Halter maxi dress", "dress neck=halter skirt=half length=maxi", W},
    {"ball_gown", "gown", "Ball gown", "dress neck=strapless shape=princess_armhole skirt=full length=maxi", W},
    {"nightgown", "nightwear", "Nightgown",
     "dress neck=scoop sleeve=long shape=boxy skirt=gathered length=maxi closure=back ease=loose", W | C},
    {"mermaid_gown", "gown", "Mermaid gown",
     "dress neck=sweetheart shape=princess_armhole skirt=trumpet length=maxi", W},
    {"little_black_dress", "dress_sheath", "Little black dress", "dress neck=boat skirt=pencil", W},
    {"tshirt_dress", "dress_knit", "T-shirt dress", "dress neck=scoop sleeve=short cloth=knit", W | C},
    {"skater_dress", "dress_knit", "Skater dress",
     "dress neck=scoop sleeve=short shape=side_waist cloth=knit skirt=full length=mini", W},
    {"apron_dress", "dress_pinafore", "Apron dress", "dress neck=halter skirt=gathered pocket=patch", W},
    {"first_communion", "dress_child", "Puff sleeve dress with a collar",
     "dress sleeve=puff collar=peter_pan closure=back shape=boxy skirt=gathered length=midi", C},

    /* a neckline, a sleeve and a skirt */
    ROWS(DRESSES_2, SHEATH, NECK_JEWEL) ROWS(DRESSES_3, SHEATH, NECK_SCOOP) ROWS(DRESSES_3, SHEATH, NECK_V)
    ROWS(DRESSES_3, SHEATH, NECK_SQUARE) ROWS(DRESSES_3, SHEATH, NECK_BOAT) ROWS(DRESSES_3, SHEATH, NECK_SWEETHEART)
    ROWS(DRESSES_3, PENCIL, NECK_JEWEL) ROWS(DRESSES_3, PENCIL, NECK_SCOOP) ROWS(DRESSES_3, PENCIL, NECK_V)
    ROWS(DRESSES_3, PENCIL, NECK_SQUARE) ROWS(DRESSES_2, PENCIL, NECK_BOAT) ROWS(DRESSES_3, PENCIL, NECK_SWEETHEART)
    ROWS(DRESSES_3, A_LINE, NECK_JEWEL) ROWS(DRESSES_3, A_LINE, NECK_SCOOP) ROWS(DRESSES_3, A_LINE, NECK_V)
    ROWS(DRESSES_2, A_LINE, NECK_SQUARE) ROWS(DRESSES_3, A_LINE, NECK_BOAT) ROWS(DRESSES_3, A_LINE, NECK_SWEETHEART)
    ROWS(DRESSES_3, SWING, NECK_JEWEL) ROWS(DRESSES_2, SWING, NECK_SCOOP) ROWS(DRESSES_3, SWING, NECK_V)
    ROWS(DRESSES_3, SWING, NECK_SQUARE) ROWS(DRESSES_3, SWING, NECK_BOAT) ROWS(DRESSES_3, SWING, NECK_SWEETHEART)
    ROWS(DRESSES_3, GATHERED, NECK_JEWEL) ROWS(DRESSES_3, GATHERED, NECK_SCOOP) ROWS(DRESSES_3, GATHERED, NECK_V)
    ROWS(DRESSES_3, GATHERED, NECK_SQUARE) ROWS(DRESSES_3, GATHERED, NECK_BOAT)
    ROWS(DRESSES_3, GATHERED, NECK_SWEETHEART)
    ROWS(DRESSES_SHORT, PLEATED, NECK_JEWEL) ROWS(DRESSES_SHORT, PLEATED, NECK_SCOOP)
    ROWS(DRESSES_SHORT, PLEATED, NECK_V) ROWS(DRESSES_SHORT, PLEATED, NECK_SQUARE)
    ROWS(DRESSES_SHORT, PLEATED, NECK_BOAT) ROWS(DRESSES_SHORT, PLEATED, NECK_SWEETHEART)

    /* princess seams and empire */
    ROWS(DRESSES_SHORT, PRINCESS_A_LINE, NECK_SCOOP) ROWS(DRESSES_SHORT, PRINCESS_HALF, NECK_SCOOP)
    ROWS(DRESSES_SHORT, PRINCESS_A_LINE, NECK_V) ROWS(DRESSES_SHORT, PRINCESS_HALF, NECK_V)
    ROWS(DRESSES_SHORT, PRINCESS_A_LINE, NECK_SQUARE) ROWS(DRESSES_SHORT, PRINCESS_HALF, NECK_SQUARE)
    ROWS(DRESSES_SHORT, PANEL_A_LINE, NECK_SCOOP) ROWS(DRESSES_SHORT, PANEL_HALF, NECK_SCOOP)
    ROWS(DRESSES_SHORT, PANEL_A_LINE, NECK_V) ROWS(DRESSES_SHORT, PANEL_HALF, NECK_V)
    ROWS(DRESSES_SHORT, PANEL_A_LINE, NECK_SQUARE) ROWS(DRESSES_SHORT, PANEL_HALF, NECK_SQUARE)
    ROWS(DRESSES_SHORT, EMPIRE_A_LINE, NECK_SCOOP) ROWS(DRESSES_SHORT, EMPIRE_GATHERED, NECK_SCOOP)
    ROWS(DRESSES_SHORT, EMPIRE_A_LINE, NECK_V) ROWS(DRESSES_SHORT, EMPIRE_GATHERED, NECK_V)
    ROWS(DRESSES_SHORT, EMPIRE_A_LINE, NECK_SQUARE) ROWS(DRESSES_SHORT, EMPIRE_GATHERED, NECK_SQUARE)

    /* gowns */
    ROW(GOWN_HALF, NECK_STRAPLESS) ROWS(GOWN_WIDE, NECK_STRAPLESS) ROW(GOWN_TRUMPET, NECK_STRAPLESS)
    ROW(GOWN_GORED, NECK_STRAPLESS)
    ROWS(GOWN_WIDE, NECK_HALTER) ROW(GOWN_TRUMPET, NECK_HALTER) ROW(GOWN_GORED, NECK_HALTER)
    ROW(GOWN_HALF, NECK_SWEETHEART) ROWS(GOWN_WIDE, NECK_SWEETHEART) ROW(GOWN_GORED, NECK_SWEETHEART)
    ROW(GOWN_HALF, NECK_DEEP_V) ROWS(GOWN_WIDE, NECK_DEEP_V) ROW(GOWN_TRUMPET, NECK_DEEP_V) ROW(GOWN_GORED, NECK_DEEP_V)

    /* sleeves of an evening, collars, knits and small ones */
    ROW(DRESS_SLEEVE, SLEEVE_CAP) ROW(DRESS_SLEEVE, SLEEVE_ELBOW) ROW(DRESS_SLEEVE, SLEEVE_THREE_QUARTER)
    ROW(DRESS_SLEEVE, SLEEVE_PUFF) ROW(DRESS_SLEEVE, SLEEVE_BISHOP) ROW(DRESS_SLEEVE, SLEEVE_BELL)
    ROW(DRESS_SLEEVE, SLEEVE_RAGLAN) ROW(DRESS_SLEEVE, SLEEVE_DOLMAN_FITTED) ROW(DRESS_SLEEVE, SLEEVE_GIGOT)
    ROWS(DRESS_COLLAR, SLEEVE_NONE) ROWS(DRESS_COLLAR, SLEEVE_SHORT) ROWS(DRESS_COLLAR, SLEEVE_THREE_QUARTER)
    CHILDREN("a_line", "a-line", " skirt=a_line")
    CHILDREN("gathered", "gathered", " skirt=gathered")
    CHILDREN("half", "half circle", " skirt=half length=mini")

    /* jumpsuits and rompers */
    {"boiler_suit", "jumpsuit", "Boiler suit",
     "jumpsuit sleeve=long collar=shirt shape=boxy ease=loose pocket=patch cuff=cuff", W | M},
    {"onesie", "jumpsuit", "Onesie",
     "jumpsuit neck=scoop sleeve=long collar=hood leg=jogger cloth=knit ease=loose closure=front", W | M | C},
    {"romper", "romper", "Romper", "jumpsuit neck=scoop sleeve=short leg_length=short", W},
    {"salopette", "jumpsuit", "Salopette",
     "jumpsuit neck=square shape=boxy leg=straight ease=loose closure=front pocket=patch", W | M | C},
    ROWS(JUMPSUITS, NECK_V) ROWS(JUMPSUITS, NECK_HALTER) ROWS(JUMPSUITS, NECK_STRAPLESS) ROWS(JUMPSUITS, NECK_BOAT)
    ROWS(JUMPSUITS, NECK_JEWEL) ROWS(JUMPSUITS, NECK_SQUARE)
    ROWS(JUMPSUITS_SHIRT, SLEEVE_SHORT) ROWS(JUMPSUITS_SHIRT, SLEEVE_LONG)
    ROWS(ROMPERS, NECK_V) ROWS(ROMPERS, NECK_HALTER) ROWS(ROMPERS, NECK_STRAPLESS) ROWS(ROMPERS, NECK_SWEETHEART)
    {"playsuit", "romper", "Playsuit", "jumpsuit sleeve=short collar=shirt leg_length=bermuda shape=boxy", W | M | C},

    /* capes and ponchos */
    CAPES("mini", "short", " length=mini") CAPES("knee", "to the knee", "") CAPES("midi", "midi", " length=midi")
    CAPES("maxi", "long", " length=maxi")
    {"poncho", "cape", "Poncho", "cape neck=scoop length=mini", W | M | C},
    {"poncho_knee", "cape", "Poncho to the knee", "cape neck=scoop", W | M | C},
    {"poncho_hood", "cape", "Hooded poncho", "cape neck=scoop length=mini collar=hood", W | M | C},
};

const int32_t mus__designs_dress_count = (int32_t)(sizeof mus__designs_dress / sizeof mus__designs_dress[0]);

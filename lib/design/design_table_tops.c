/*
 * design_table_tops.c: named designs: tops, blouses, shirts, coats, knits, tunics. How rows and families are written:
 * design_table.h.
 */
#include "design/design_table.h"

/* ---- families: the parts of an option are named x, X, xw: name, title, words ---- */

#define BLOUSE(n, N, nw, s, S, sw) {"blouse_" n "_" s, "blouse", "Blouse, " N ", " S, "top" nw sw, W},
#define BLOUSES_9(...) \
    ROW(BLOUSE, __VA_ARGS__, SLEEVE_NONE) ROW(BLOUSE, __VA_ARGS__, SLEEVE_CAP) ROW(BLOUSE, __VA_ARGS__, SLEEVE_SHORT) \
    ROW(BLOUSE, __VA_ARGS__, SLEEVE_ELBOW) ROW(BLOUSE, __VA_ARGS__, SLEEVE_THREE_QUARTER) \
    ROW(BLOUSE, __VA_ARGS__, SLEEVE_LONG) ROW(BLOUSE, __VA_ARGS__, SLEEVE_PUFF) \
    ROW(BLOUSE, __VA_ARGS__, SLEEVE_BISHOP) ROW(BLOUSE, __VA_ARGS__, SLEEVE_BELL)
#define BLOUSES_2(...) ROW(BLOUSE, __VA_ARGS__, SLEEVE_DOLMAN_FITTED) ROW(BLOUSE, __VA_ARGS__, SLEEVE_GIGOT)
#define BLOUSES_11(...) BLOUSES_9(__VA_ARGS__) BLOUSES_2(__VA_ARGS__)
#define BLOUSES_12(...) BLOUSES_9(__VA_ARGS__) ROW(BLOUSE, __VA_ARGS__, SLEEVE_RAGLAN) BLOUSES_2(__VA_ARGS__)

#define BLOUSE_COLLAR(c, title, cw, s, S, sw) \
    {"blouse_" c "_" s, "blouse_collar", "Blouse, " title " collar, " S, "top" sw cw, W},
#define BLOUSES_COLLAR(...) \
    ROW(BLOUSE_COLLAR, __VA_ARGS__, SLEEVE_NONE) ROW(BLOUSE_COLLAR, __VA_ARGS__, SLEEVE_SHORT) \
    ROW(BLOUSE_COLLAR, __VA_ARGS__, SLEEVE_THREE_QUARTER) ROW(BLOUSE_COLLAR, __VA_ARGS__, SLEEVE_LONG) \
    ROW(BLOUSE_COLLAR, __VA_ARGS__, SLEEVE_PUFF) ROW(BLOUSE_COLLAR, __VA_ARGS__, SLEEVE_BISHOP)

#define SHIRT(name, title, words, groups, s, S, sw) {name s, "shirt", title ", " S, "top" sw words, groups},
#define SHIRT_KINDS(...) \
    SHIRT("shirt_yoke_", "Shirt with a yoke", " shape=boxy collar=shirt yoke=yoke", W | M | C, __VA_ARGS__) \
    SHIRT("shirt_wide_", "Wide shirt", " shape=boxy collar=shirt ease=loose pocket=patch", W | M | C, __VA_ARGS__) \
    SHIRT("shirt_mandarin_", "Collarless shirt with a stand", " shape=boxy collar=mandarin closure=front", W | M | C, \
          __VA_ARGS__) \
    SHIRT("shirt_princess_", "Princess shirt", " shape=princess_armhole collar=shirt", W, __VA_ARGS__)
#define SHIRTS_FITTED(...) ROW(SHIRT, "shirt_", "Fitted shirt", " collar=shirt", W, __VA_ARGS__)
#define SHIRTS_STRAIGHT(...) \
    ROW(SHIRT, "shirt_straight_", "Straight shirt", " shape=boxy collar=shirt", W | M | C, __VA_ARGS__)

#define TOP(n, N, nw, shape, title, family, s, S, sw) \
    {"top_" shape "_" n "_" s, family, "Top, " title ", " N ", " S, "top" nw sw " shape=" shape, W},
#define TOPS(...) \
    ROW(TOP, __VA_ARGS__, SLEEVE_NONE) ROW(TOP, __VA_ARGS__, SLEEVE_SHORT) ROW(TOP, __VA_ARGS__, SLEEVE_LONG)
#define TOPS_6(...) ROWS(TOPS, NECK_JEWEL, __VA_ARGS__) ROWS(TOPS, NECK_SCOOP, __VA_ARGS__)
#define TOPS_12(...) \
    TOPS_6(__VA_ARGS__) ROWS(TOPS, NECK_V, __VA_ARGS__) ROWS(TOPS, NECK_SQUARE, __VA_ARGS__)

/* no shoulders: strapless and halter tops */
#define BARE(neck, title, shape, shape_title, shape_words, l, L, lw) \
    {neck "_" shape "_" l, neck, title ", " shape_title ", " L, "top neck=" neck shape_words lw, W},
#define BARES(...) ROW(BARE, __VA_ARGS__, TOP_CROP) ROW(BARE, __VA_ARGS__, TOP_WAIST) ROW(BARE, __VA_ARGS__, TOP_HIP)

#define KNIT(n, N, nw, groups, s, S, sw) \
    {"knit_" n "_" s, "knit_top", "Knit top, " N ", " S, "top" nw sw " cloth=knit", groups},
#define KNIT_LENGTH(l, L, lw, groups, s, S, sw) \
    {"knit_" l "_" s, "knit_top", "Knit top, " L ", " S, "top neck=scoop" sw " cloth=knit" lw, groups},
#define KNIT_LENGTHS(...) \
    ROW(KNIT_LENGTH, __VA_ARGS__, SLEEVE_NONE) ROW(KNIT_LENGTH, __VA_ARGS__, SLEEVE_SHORT) \
    ROW(KNIT_LENGTH, __VA_ARGS__, SLEEVE_LONG)

#define TUNIC(n, N, nw, groups, s, S, sw) \
    {"tunic_" n "_" s, "tunic", "Tunic, " N ", " S, \
     "top" nw sw " shape=boxy closure=back top_length=tunic ease=loose", groups},
#define TUNICS(...) \
    ROW(TUNIC, __VA_ARGS__, W | M | C, SLEEVE_NONE) ROW(TUNIC, __VA_ARGS__, W | M | C, SLEEVE_SHORT) \
    ROW(TUNIC, __VA_ARGS__, W | M | C, SLEEVE_THREE_QUARTER) ROW(TUNIC, __VA_ARGS__, W | M | C, SLEEVE_LONG) \
    ROW(TUNIC, __VA_ARGS__, W | C, SLEEVE_BELL)

const mus__design_row mus__designs_top[] = {
    /* T-shirt and blocks */
    {"tshirt", "top", "T-shirt", "top sleeve=tee shape=boxy cloth=knit", W | M | C},
    {"sleeveless", "top", "Sleeveless top", "top shape=boxy cloth=knit", W | M | C},
    {"bodice", "block", "Bodice block", "top top_length=waist ease=block", W | M | C},
    {"skirt", "skirt", "Straight skirt", "skirt skirt=block band=none", W | M | C},
    {"skirt_plain", "skirt", "A-line skirt without darts", "skirt skirt=plain band=none", W | M | C},

    /* tops, classics by their names */
    {"tank", "knit_top", "Tank top", "top neck=scoop sleeve=none cloth=knit", W | M | C},
    {"tee_crew", "knit_top", "Round neck T-shirt", "top sleeve=short cloth=knit", W | M | C},
    {"tee_v", "knit_top", "V neck T-shirt", "top neck=v sleeve=short cloth=knit", W | M | C},
    {"breton", "knit_top", "Breton boat top", "top neck=boat sleeve=three_quarter cloth=knit", W | M | C},
    {"polo", "knit_top", "Polo shirt", "top sleeve=short collar=shirt shape=boxy closure=front cloth=knit", W | M | C},
    {"sweatshirt", "knit_top", "Sweatshirt", "top neck=scoop sleeve=raglan cloth=knit ease=loose cuff=rib hem=ribbed",
     W | M | C},
    {"hoodie", "knit_top", "Hoodie",
     "top sleeve=long collar=hood cloth=knit ease=loose cuff=rib neck=scoop hem=ribbed pocket=kangaroo", W | M | C},
    {"hoodie_zip", "knit_top", "Zip hoodie",
     "top sleeve=long collar=hood cloth=knit ease=loose cuff=rib closure=front hem=ribbed pocket=kangaroo", W | M | C},
    {"turtleneck", "knit_top", "Turtleneck", "top sleeve=long collar=turtleneck cloth=knit", W | M | C},
    {"oxford_shirt", "shirt", "Oxford shirt",
     "top sleeve=long shape=boxy collar=shirt yoke=yoke cuff=cuff pocket=patch", W | M | C},
    {"stand_blouse", "blouse", "Blouse with a stand", "top sleeve=bishop collar=mandarin cuff=cuff closure=back", W},
    {"peasant_blouse", "blouse", "Peasant blouse",
     "top neck=scoop sleeve=raglan shape=boxy ease=loose top_length=hip", W | C},
    {"kimono_top", "blouse", "Kimono top", "top neck=v sleeve=dolman shape=boxy ease=loose", W | M},
    {"gilet", "waistcoat", "Gilet", "top neck=v shape=princess_armhole closure=front top_length=waist", W},
    {"waistcoat", "waistcoat", "Waistcoat", "top neck=deep_v shape=waist closure=front top_length=waist", W | M},
    {"bolero", "waistcoat", "Bolero",
     "top neck=scoop sleeve=three_quarter shape=princess_armhole closure=front top_length=crop", W},
    {"corset_top", "strapless", "Corset top",
     "top neck=strapless shape=princess_armhole ease=slim top_length=waist", W},
    {"bustier", "strapless", "Bustier", "top neck=strapless shape=waist top_length=crop", W},
    {"choli", "blouse", "Choli (sari blouse)",
     "top neck=scoop sleeve=short shape=princess_armhole ease=slim top_length=crop", W},
    {"kurta", "tunic", "Kurta",
     "top sleeve=long shape=boxy collar=mandarin closure=front top_length=tunic ease=loose", W | M | C},
    {"tabard", "tunic", "Tabard", "top neck=scoop shape=boxy ease=loose top_length=tunic", W | M | C},
    {"scrub_top", "blouse", "Scrub top", "top neck=v sleeve=short shape=boxy pocket=patch", W | M},
    {"middy", "blouse", "Middy blouse",
     "top neck=v sleeve=long shape=boxy collar=sailor closure=front cuff=cuff", W | C},
    {"shirt", "shirt", "Shirt", "top sleeve=long shape=boxy collar=shirt cuff=cuff", W | M | C},
    {"coat", "coat", "Coat",
     "top neck=v sleeve=long shape=boxy collar=shawl closure=front top_length=tunic ease=coat pocket=welt", W | M | C},
    {"coat_stand", "coat", "Coat with a stand",
     "top sleeve=long shape=boxy collar=mandarin closure=front top_length=tunic ease=coat pocket=flap", W | M | C},
    {"coat_short", "coat", "Short coat",
     "top neck=v sleeve=long shape=boxy collar=shawl closure=front ease=coat pocket=patch", W | M | C},
    {"pyjama_jacket", "nightwear", "Pyjama jacket",
     "top neck=v sleeve=long shape=boxy collar=shawl ease=loose pocket=patch", W | M},

    /* blouses: a neckline and a sleeve on the darted bodice */
    ROWS(BLOUSES_12, NECK_JEWEL) ROWS(BLOUSES_12, NECK_SCOOP) ROWS(BLOUSES_12, NECK_V)
    ROWS(BLOUSES_11, NECK_SQUARE) ROWS(BLOUSES_11, NECK_BOAT) ROWS(BLOUSES_11, NECK_SWEETHEART)
    ROWS(BLOUSES_11, NECK_KEYHOLE)

    /* collars */
    BLOUSES_COLLAR("mandarin", "mandarin", " collar=mandarin closure=front")
    BLOUSES_COLLAR("peter_pan", "Peter Pan", " collar=peter_pan closure=front")
    BLOUSES_COLLAR("shawl", "shawl", " collar=shawl")
    BLOUSES_COLLAR("sailor", "sailor", " collar=sailor neck=v closure=front")

    /* shirts */
    SHIRTS_FITTED(SLEEVE_NONE) SHIRTS_FITTED(SLEEVE_SHORT) SHIRTS_FITTED(SLEEVE_ELBOW)
    SHIRTS_FITTED(SLEEVE_THREE_QUARTER) SHIRTS_FITTED(SLEEVE_LONG) SHIRTS_FITTED(SLEEVE_PUFF)
    SHIRTS_FITTED(SLEEVE_BISHOP) SHIRTS_FITTED(SLEEVE_GIGOT)
    SHIRTS_STRAIGHT(SLEEVE_NONE) SHIRTS_STRAIGHT(SLEEVE_SHORT) SHIRTS_STRAIGHT(SLEEVE_ELBOW)
    SHIRTS_STRAIGHT(SLEEVE_THREE_QUARTER) SHIRTS_STRAIGHT(SLEEVE_LONG)
    ROWS(SHIRT_KINDS, SLEEVE_SHORT) ROWS(SHIRT_KINDS, SLEEVE_LONG)
    {"shirt_cuffed", "shirt", "Fitted shirt with cuffs", "top sleeve=long collar=shirt cuff=cuff", W},
    {"shirt_tunic", "tunic", "Long shirt",
     "top sleeve=long shape=boxy collar=shirt top_length=tunic cuff=cuff", W | M | C},
    {"shirt_crop", "shirt", "Cropped shirt", "top sleeve=short shape=boxy collar=shirt top_length=waist", W | M},

    /* where the bust and waist are shaped */
    TOPS_12("waist", "waist darts", "top_darts")
    TOPS_12("shoulder_waist", "shoulder darts", "top_darts")
    TOPS_12("french", "French darts", "top_darts")
    TOPS_12("princess_shoulder", "shoulder princess seams", "top_princess")
    TOPS_12("princess_armhole", "armhole princess seams", "top_princess")
    TOPS_6("neck_gathers", "gathered neck", "top_gathers")
    TOPS_12("cf_gathers", "gathered centre front", "top_gathers")
    TOPS_12("empire", "empire seam", "top_gathers")

    /* without shoulders */
    BARES("strapless", "Strapless top", "side_waist", "darts", "")
    ROW(BARE, "strapless", "Strapless top", "waist", "waist darts", " shape=waist", TOP_WAIST)
    ROW(BARE, "strapless", "Strapless top", "waist", "waist darts", " shape=waist", TOP_HIP)
    BARES("strapless", "Strapless top", "french", "French darts", " shape=french")
    BARES("strapless", "Strapless top", "princess_armhole", "princess seams", " shape=princess_armhole")
    BARES("strapless", "Strapless top", "empire", "empire seam", " shape=empire")
    BARES("strapless", "Strapless top", "cf_gathers", "gathered front", " shape=cf_gathers")
    BARES("halter", "Halter top", "side_waist", "darts", "")
    BARES("halter", "Halter top", "waist", "waist darts", " shape=waist")
    BARES("halter", "Halter top", "french", "French darts", " shape=french")
    BARES("halter", "Halter top", "princess_armhole", "princess seams", " shape=princess_armhole")
    BARES("halter", "Halter top", "empire", "empire seam", " shape=empire")
    BARES("halter", "Halter top", "cf_gathers", "gathered front", " shape=cf_gathers")

    /* knits */
    ROW(KNIT, NECK_JEWEL, W | M | C, SLEEVE_NONE) ROW(KNIT, NECK_JEWEL, W | M | C, SLEEVE_CAP)
    ROW(KNIT, NECK_JEWEL, W | M | C, SLEEVE_ELBOW) ROW(KNIT, NECK_JEWEL, W | M | C, SLEEVE_THREE_QUARTER)
    ROW(KNIT, NECK_JEWEL, W | M | C, SLEEVE_LONG) ROW(KNIT, NECK_JEWEL, W | M | C, SLEEVE_RAGLAN)
    ROW(KNIT, NECK_JEWEL, W | M, SLEEVE_DOLMAN)
    ROW(KNIT, NECK_SCOOP, W | M | C, SLEEVE_CAP) ROW(KNIT, NECK_SCOOP, W | M | C, SLEEVE_SHORT)
    ROW(KNIT, NECK_SCOOP, W | M | C, SLEEVE_ELBOW) ROW(KNIT, NECK_SCOOP, W | M | C, SLEEVE_THREE_QUARTER)
    ROW(KNIT, NECK_SCOOP, W | M | C, SLEEVE_LONG) ROW(KNIT, NECK_SCOOP, W | M | C, SLEEVE_RAGLAN)
    ROW(KNIT, NECK_SCOOP, W | M, SLEEVE_DOLMAN)
    ROW(KNIT, NECK_V, W | M | C, SLEEVE_NONE) ROW(KNIT, NECK_V, W | M | C, SLEEVE_CAP)
    ROW(KNIT, NECK_V, W | M | C, SLEEVE_ELBOW) ROW(KNIT, NECK_V, W | M | C, SLEEVE_THREE_QUARTER)
    ROW(KNIT, NECK_V, W | M | C, SLEEVE_LONG) ROW(KNIT, NECK_V, W | M | C, SLEEVE_RAGLAN)
    ROW(KNIT, NECK_V, W | M, SLEEVE_DOLMAN)
    ROW(KNIT, NECK_BOAT, W | M | C, SLEEVE_NONE) ROW(KNIT, NECK_BOAT, W | M | C, SLEEVE_CAP)
    ROW(KNIT, NECK_BOAT, W | M | C, SLEEVE_SHORT) ROW(KNIT, NECK_BOAT, W | M | C, SLEEVE_ELBOW)
    ROW(KNIT, NECK_BOAT, W | M | C, SLEEVE_LONG) ROW(KNIT, NECK_BOAT, W | M, SLEEVE_DOLMAN)
    ROW(KNIT, NECK_SQUARE, W | M | C, SLEEVE_NONE) ROW(KNIT, NECK_SQUARE, W | M | C, SLEEVE_CAP)
    ROW(KNIT, NECK_SQUARE, W | M | C, SLEEVE_SHORT) ROW(KNIT, NECK_SQUARE, W | M | C, SLEEVE_ELBOW)
    ROW(KNIT, NECK_SQUARE, W | M | C, SLEEVE_THREE_QUARTER) ROW(KNIT, NECK_SQUARE, W | M | C, SLEEVE_LONG)
    ROW(KNIT, NECK_SQUARE, W | M, SLEEVE_DOLMAN)
    ROWS(KNIT_LENGTHS, TOP_CROP, W | M) ROWS(KNIT_LENGTHS, TOP_WAIST, W | M | C)
    ROWS(KNIT_LENGTHS, TOP_TUNIC, W | M | C)
    {"knit_wide_short", "knit_top", "Wide knit top, short sleeves",
     "top neck=scoop sleeve=short cloth=knit ease=loose", W | M | C},
    {"knit_close_short", "knit_top", "Close knit top, short sleeves",
     "top neck=scoop sleeve=short cloth=knit ease=slim", W | M | C},
    {"knit_wide_long", "knit_top", "Wide knit top, long sleeves",
     "top neck=scoop sleeve=long cloth=knit ease=loose", W | M | C},
    {"knit_close_long", "knit_top", "Close knit top, long sleeves",
     "top neck=scoop sleeve=long cloth=knit ease=slim", W | M | C},
    {"knit_close_sleeveless", "knit_top", "Close tank top", "top neck=scoop cloth=knit ease=slim", W | M | C},
    {"turtleneck_sleeveless", "knit_top", "Sleeveless turtleneck", "top collar=turtleneck cloth=knit", W | M},
    {"turtleneck_short", "knit_top", "Turtleneck, short sleeves",
     "top sleeve=short collar=turtleneck cloth=knit", W | M | C},
    {"turtleneck_close", "knit_top", "Close turtleneck",
     "top sleeve=long collar=turtleneck cloth=knit ease=slim", W | M},
    {"hoodie_sleeveless", "knit_top", "Sleeveless hoodie",
     "top neck=scoop collar=hood cloth=knit ease=loose hem=ribbed pocket=kangaroo", W | M | C},
    {"hoodie_short", "knit_top", "Hoodie, short sleeves",
     "top neck=scoop sleeve=short collar=hood cloth=knit pocket=kangaroo", W | M | C},
    {"hoodie_raglan", "knit_top", "Raglan hoodie",
     "top neck=scoop sleeve=raglan collar=hood cloth=knit ease=loose cuff=rib hem=ribbed pocket=kangaroo", W | M | C},
    {"hoodie_v", "knit_top", "Hoodie on a V neck",
     "top neck=v sleeve=long collar=hood cloth=knit ease=loose cuff=rib pocket=kangaroo", W | M | C},

    /* tunics and nightwear */
    ROWS(TUNICS, NECK_JEWEL) ROWS(TUNICS, NECK_V) ROWS(TUNICS, NECK_SQUARE)
    {"nightshirt", "nightwear", "Nightshirt",
     "top sleeve=long shape=boxy collar=shirt top_length=tunic ease=loose pocket=patch", W | M | C},
};

const int32_t mus__designs_top_count = (int32_t)(sizeof mus__designs_top / sizeof mus__designs_top[0]);

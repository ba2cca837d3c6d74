/*
 * design_table.h: rows of the named designs, and the options that families of them are made of.
 *
 * A row is name, family, title, words, groups (W women, M men, C children). A family of rows multiplies axes: an option
 * of an axis (NECK_V, SLEEVE_SHORT, LENGTH_MINI ...) is three texts, its part of the name, of the title and of the
 * words, which the family's row macro joins at compile time. So
 *
 *     ROWS(TOPS, NECK_JEWEL, "waist", "waist darts", "top_darts")
 *
 * is the rows "top_waist_jewel_sleeveless", "top_waist_jewel_short" and "top_waist_jewel_long". A product that has a
 * name of its own (kilt, pinafore) stands in its place or among the classics, and is left out of the family. To add a
 * garment, add a row to one of the tables; to add a family, add a row macro above the table.
 */
#ifndef MUS_DESIGN_TABLE_H
#define MUS_DESIGN_TABLE_H

#include "muslin/design.h"

typedef struct mus__design_row {
    const char *name, *family, *title;
    const char *words;
    int32_t groups;    /* bits of MUS_GROUP_* */
} mus__design_row;

extern const mus__design_row mus__designs_top[], mus__designs_lower[], mus__designs_dress[];
extern const int32_t mus__designs_top_count, mus__designs_lower_count, mus__designs_dress_count;

#define W MUS_GROUP_WOMEN
#define M MUS_GROUP_MEN
#define C MUS_GROUP_CHILDREN

/* one row, and several, of options that expand to three arguments each */
#define ROW(FAMILY, ...) FAMILY(__VA_ARGS__)
#define ROWS(FAMILY, ...) FAMILY(__VA_ARGS__)

/* ---- options: name, title, words ---- */

#define SLEEVE_NONE "sleeveless", "sleeveless", ""
#define SLEEVE_CAP "cap", "cap sleeves", " sleeve=cap"
#define SLEEVE_SHORT "short", "short sleeves", " sleeve=short"
#define SLEEVE_ELBOW "elbow", "elbow sleeves", " sleeve=elbow"
#define SLEEVE_THREE_QUARTER "three_quarter", "three-quarter sleeves", " sleeve=three_quarter"
#define SLEEVE_LONG "long", "long sleeves", " sleeve=long"
#define SLEEVE_PUFF "puff", "puff sleeves", " sleeve=puff"
#define SLEEVE_BISHOP "bishop", "bishop sleeves", " sleeve=bishop"
#define SLEEVE_BELL "bell", "bell sleeves", " sleeve=bell"
#define SLEEVE_RAGLAN "raglan", "raglan sleeves", " sleeve=raglan"
#define SLEEVE_DOLMAN "dolman", "dolman sleeves", " sleeve=dolman"
#define SLEEVE_DOLMAN_FITTED "dolman", "dolman sleeves", " sleeve=dolman shape=waist"
#define SLEEVE_GIGOT "gigot", "gigot sleeves", " sleeve=gigot"

#define NECK_JEWEL "jewel", "round neck", ""
#define NECK_SCOOP "scoop", "scoop neck", " neck=scoop"
#define NECK_V "v", "V neck", " neck=v"
#define NECK_DEEP_V "deep_v", "deep V neck", " neck=deep_v"
#define NECK_SQUARE "square", "square neck", " neck=square"
#define NECK_BOAT "boat", "boat neck", " neck=boat"
#define NECK_SWEETHEART "sweetheart", "sweetheart neck", " neck=sweetheart"
#define NECK_KEYHOLE "keyhole", "keyhole neck", " neck=keyhole"
#define NECK_HALTER "halter", "halter neck", " neck=halter"
#define NECK_STRAPLESS "strapless", "strapless", " neck=strapless"

#define TOP_CROP "crop", "cropped", " top_length=crop"
#define TOP_WAIST "waist", "to the waist", " top_length=waist"
#define TOP_HIP "hip", "to the hip", ""
#define TOP_TUNIC "tunic", "tunic", " top_length=tunic"

#define SKIRT_STRAIGHT "straight", "Straight skirt", ""
#define SKIRT_PENCIL "pencil", "Pencil skirt", " skirt=pencil"
#define SKIRT_A_LINE "a_line", "A-line skirt", " skirt=a_line"
#define SKIRT_GORED4 "gored4", "Skirt of four gores", " skirt=gored4"
#define SKIRT_GORED6 "gored6", "Skirt of six gores", " skirt=gored6"
#define SKIRT_GORED8 "gored8", "Skirt of eight gores", " skirt=gored8"
#define SKIRT_QUARTER "quarter", "Quarter circle skirt", " skirt=quarter"
#define SKIRT_HALF "half", "Half circle skirt", " skirt=half"
#define SKIRT_THREE_QUARTER "three_quarter", "Three-quarter circle skirt", " skirt=three_quarter"
#define SKIRT_FULL "full", "Full circle skirt", " skirt=full"
#define SKIRT_GATHERED "gathered", "Gathered skirt", " skirt=gathered"
#define SKIRT_KNIFE "knife", "Knife pleated skirt", " skirt=knife"
#define SKIRT_BOX "box", "Box pleated skirt", " skirt=box"
#define SKIRT_TIERED "tiered", "Tiered skirt", " skirt=tiered"
#define SKIRT_WRAP "wrap", "Wrap skirt", " skirt=wrap"
#define SKIRT_GODET "godet", "Skirt with godets", " skirt=godet"
#define SKIRT_TRUMPET "trumpet", "Trumpet skirt", " skirt=trumpet"

#define LENGTH_MINI "mini", "mini", " length=mini"
#define LENGTH_KNEE "knee", "to the knee", ""
#define LENGTH_MIDI "midi", "midi", " length=midi"
#define LENGTH_MAXI "maxi", "maxi", " length=maxi"
#define LENGTH_HI_LOW "hi_low", "high-low", " length=hi_low"

#define LEG_STRAIGHT "straight", "Straight trousers", ""
#define LEG_TAPERED "tapered", "Tapered trousers", " leg=tapered"
#define LEG_BOOTCUT "bootcut", "Bootcut trousers", " leg=bootcut"
#define LEG_FLARE "flare", "Flared trousers", " leg=flare"
#define LEG_WIDE "wide", "Wide trousers", " leg=wide"

#endif

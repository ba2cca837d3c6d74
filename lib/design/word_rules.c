/*
 * word_rules.c: the rules of which words go together. A rule is up to four conditions and a reason; a style that meets
 * all of them is refused with the reason. A condition lists the options of an axis that meet it
 * ("neck=halter,strapless") or that do not ("sleeve!=none"). A garment without that axis never meets it.
 *
 * The first rules leave 1617 tops (4068 with closures), 70 skirts (234 with bands), 27 trousers (95), 98896 dresses and
 * 38583 jumpsuits, as counted by an independent script; a test enumerates them. Rules about collars, cuffs, yokes and
 * eases, which are not counted, come after them.
 */
#include <stdio.h>
#include <string.h>

#include "design/words.h"

static const struct {
    const char *met[4];
    const char *why;
} rules_list[] = {
    /* necks and what hangs on them */
    {{"neck=halter,strapless", "sleeve!=none"}, "a sleeve hangs on a shoulder"},
    {{"neck=halter,strapless,sweetheart", "collar!=none"}, "a collar lies on a neckline that goes round the neck"},
    {{"neck=strapless", "shape=boxy,neck_gathers,princess_shoulder,shoulder_waist"},
     "without shoulders a top holds by darts below the bust"},
    {{"neck=halter", "shape=princess_shoulder,shoulder_waist"}, "there is no shoulder for the dart to end on"},
    {{"neck=keyhole", "closure!=back"}, "its slit is the front opening's place, it buttons behind"},
    {{"neck=boat", "shape=shoulder_waist"}, "the shoulder is too short for a dart"},
    {{"shape=neck_gathers", "neck!=jewel,scoop"}, "gathers lie along a round neckline"},
    {{"shape=neck_gathers", "collar!=none"}, "gathers lie where the collar would be sewn on"},

    /* collars */
    {{"collar=mandarin,shirt,turtleneck", "neck!=jewel"}, "it stands at the neck"},
    {{"collar=peter_pan", "neck!=jewel,scoop"}, "it lies on a round neckline"},
    {{"collar=hood", "neck!=jewel,scoop,v"}, "it is drawn for a round neckline or a V"},
    {{"collar=shirt", "closure!=front"}, "it buttons in front"},
    {{"collar=peter_pan", "closure!=front,back"}, "its two halves meet at an opening"},
    {{"collar=mandarin", "closure=none,side"}, "it is too narrow for the head"},

    /* openings, and sleeves that are one with the shoulder */
    {{"closure=none", "shape!=boxy", "cloth=woven"}, "a fitted woven top needs an opening"},
    {{"closure=front", "shape=cf_gathers"}, "gathers lie on the centre front"},
    {{"closure=side", "sleeve=dolman"}, "its underarm is not a side seam"},
    {{"sleeve=raglan,dolman", "shape=shoulder_waist,princess_shoulder,princess_armhole"},
     "the seam that the shape ends on is not there"},
    {{"sleeve=raglan", "neck!=jewel,scoop,v"}, "its seams run into a round neckline or a V"},

    /* skirts */
    {{"skirt=pencil", "length=maxi"}, "one cannot walk in it"},
    {{"length=hi_low", "skirt!=half,three_quarter,full,gathered,wrap"}, "its hem needs width to fall"},
    {{"skirt=trumpet", "length=mini,hi_low"}, "it flares below the knee"},
    {{"skirt=godet", "length=mini"}, "there is no height for godets"},
    {{"band=elastic", "skirt!=gathered,tiered,full,three_quarter,half"}, "the top edge does not pass the hips"},
    {{"garment=dress", "shape=empire", "skirt=pencil,trumpet"}, "what hangs from under the bust cannot be narrow"},

    /* legs */
    {{"leg=bootcut,flare", "leg_length=short,bermuda"}, "it widens below the knee"},
    {{"leg=culotte", "leg_length=short,ankle,full"}, "it ends at the calf"},
    {{"leg=jogger,harem", "leg_length=short,bermuda,capri"}, "its rib holds at the ankle"},
    {{"band=elastic", "leg=tapered,bootcut,flare,culotte", "cloth=woven"}, "the top edge does not pass the hips"},

    /* not counted */
    {{"closure=none", "band!=elastic,none", "garment=skirt,trousers", "cloth=woven"}, "a fitted band needs an opening"},
    {{"closure!=none", "band=elastic"}, "it passes the hips without an opening"},
    {{"garment=jumpsuit", "closure=none", "cloth=woven"}, "one steps into it through its opening"},
    {{"closure=wrap", "garment!=dress"}, "its fronts are held at the waist, above a skirt"},
    {{"closure=wrap", "neck!=deep_v"}, "its neckline runs from the shoulder to the tie"},
    {{"closure=wrap", "skirt!=wrap"}, "the skirt below it wraps too"},
    {{"closure=wrap", "shape!=side_waist"}, "its fronts have the darts of the block"},
    {{"closure=wrap", "collar!=none"}, "its neckline ends at the tie"},
    {{"closure=wrap", "sleeve=dolman"}, "its underarm is not a side seam"},
    {{"closure=wrap", "length=hi_low"}, "its edges hang down to the hem"},
    {{"closure=wrap", "pocket!=none"}, "one of the two would lie under the other front"},
    {{"closure=wrap", "cloth=knit"}, "its neckline is faced, and no ring that a band of rib goes round"},
    {{"collar=shawl", "neck!=v,deep_v"}, "its front edge runs on from a V"},
    {{"collar=shawl", "closure!=front"}, "its two halves meet at the front opening"},
    {{"collar=sailor", "neck!=jewel,scoop,v"}, "it lies on a round neckline or a V"},
    {{"cuff=cuff,rib", "sleeve=none,cap,bell,tee"}, "there is no narrow end to sew it to"},
    {{"yoke=yoke", "neck=halter,strapless"}, "there is no shoulder to cut it from"},
    {{"yoke=yoke", "sleeve=raglan,dolman"}, "the sleeve takes its place"},
    {{"yoke=yoke", "shape=princess_shoulder,shoulder_waist,neck_gathers"}, "it would cut what ends on the shoulder"},
    {{"yoke=yoke", "garment=trousers", "closure=back,side"}, "its seam would cross the zip"},
    {{"pocket=kangaroo", "garment!=top"}, "it lies on the front of a top"},
    {{"pocket=kangaroo", "top_length=crop,waist"}, "there is no front below the waist to sew it to"},
    {{"pocket=kangaroo", "shape!=boxy"}, "it lies on a front without seams and darts"},
    {{"hem=ribbed", "cloth=woven"}, "a rib draws in what stretches"},
    {{"hem=ribbed", "closure=back"}, "the zip would end above the rib"},
    {{"ease=loose,coat", "neck=strapless"}, "only what is close stays up"},
    {{"ease=coat", "garment=skirt,trousers,jumpsuit"}, "a coat hangs open from the shoulders"},
    {{"ease=coat", "closure!=front"}, "a coat goes on over clothes and opens in front"},
    {{"ease=slim", "shape=boxy", "cloth=woven"}, "without darts a close woven top does not go on"},
    {{"garment=cape", "neck!=jewel,scoop"}, "it hangs from a round neckline"},
    {{"garment=cape", "collar=shirt,peter_pan,turtleneck,shawl,sailor"}, "a cape has a stand or a hood"},
    {{"garment=cape", "closure=side,back,seams"}, "it opens in front"},
    {{"garment=cape", "length=hi_low"}, "its hem is one circle"},

    /* T-shirts and blocks */
    {{"sleeve=tee", "cloth=woven"}, "its flat cap is cut for a knit"},
    {{"ease=block", "garment!=top"}, "the bodice block ends at the waist"},
    {{"ease=block", "top_length!=waist"}, "the bodice block ends at the waist"},
    {{"ease=block", "closure!=seams"}, "the bodice block is cut in four pieces"},
    {{"closure=seams", "ease!=block"}, "the bodice block alone is cut in four pieces"},
    {{"ease=block", "neck!=jewel"}, "the bodice block has its own neckline"},
    {{"ease=block", "sleeve!=none"}, "the bodice block has no sleeve"},
    {{"ease=block", "shape!=side_waist"}, "the bodice block has its own darts"},
    {{"ease=block", "collar!=none"}, "the bodice block has no collar"},
    {{"ease=block", "yoke=yoke"}, "the bodice block has no yoke"},
    {{"ease=block", "hem=ribbed"}, "the bodice block has no hem"},
    {{"ease=block", "cloth=knit"}, "the bodice block is drafted for a woven cloth"},
    {{"skirt=block,plain", "garment=dress"}, "its top edge is not drafted to a bodice"},
    {{"skirt=block,plain", "band!=none"}, "it is cut without a band"},
    {{"skirt=block,plain", "closure!=none"}, "it is cut without an opening"},
    {{"skirt=block,plain", "length!=knee"}, "it has one length, 0.36 of the stature"},
    {{"skirt=block,plain", "rise!=natural"}, "its top edge lies on the waist"},
    {{"skirt=block,plain", "ease!=regular"}, "it has its own ease"},
    {{"band=none", "garment=trousers"}, "trousers hang from a band or a facing"},
    {{"band=none", "skirt!=block,plain"}, "what is fitted or gathered hangs from a band or a facing"},
};

#define WORD_RULES ((int32_t)(sizeof rules_list / sizeof rules_list[0]))


/* the axis that a condition names */
static int32_t rules_condition_axis(const char *condition)
{
    const size_t n = strcspn(condition, "!=");
    for (int32_t a = 0; a < MUS__AXIS_COUNT; a++)
        if (strncmp(mus__style_axis(a), condition, n) == 0 && mus__style_axis(a)[n] == '\0') return a;
    return MUS_NONE;
}


static bool rules_met(const char *condition, const mus__style *style, uint32_t named)
{
    const int32_t axis = rules_condition_axis(condition);
    if (!mus__style_has(style->option[0], axis) || (named >> axis & 1) == 0) return false;
    const char *list = condition + strcspn(condition, "!="), *word = mus__style_word(axis, style->option[axis]);
    const bool wanted = *list != '!';
    list += wanted ? 1 : 2;

    /* the word among those between commas */
    for (const size_t length = strlen(word); *list != '\0'; ) {
        const size_t n = strcspn(list, ",");
        if (n == length && memcmp(list, word, n) == 0) return wanted;
        list += n + (list[n] == ',');
    }
    return !wanted;
}


int32_t mus__style_broken(const mus__style *style, uint32_t named)
{
    for (int32_t r = 0; r < WORD_RULES; r++) {
        bool met = true;
        for (int32_t i = 0; i < 4 && met && rules_list[r].met[i] != NULL; i++)
            met = rules_met(rules_list[r].met[i], style, named);
        if (met) return r;
    }
    return MUS_NONE;
}


mus_status mus__style_explain(mus_context *context, const mus__style *style, int32_t rule)
{
    if (rule == MUS_NONE) return MUS_OK;
    static const char *const before[] = {"", " excludes ", " with ", " and "};
    char text[4][64] = {"", "", "", ""};
    for (int32_t i = 0; i < 4 && rules_list[rule].met[i] != NULL; i++) {
        const int32_t axis = rules_condition_axis(rules_list[rule].met[i]);
        snprintf(text[i], sizeof text[i], "%s%s=%s", before[i], mus__style_axis(axis),
                 mus__style_word(axis, style->option[axis]));
    }
    return mus__fail(context, MUS_ERR_DESIGN, "%s%s%s%s: %s", text[0], text[1], text[2], text[3],
                     rules_list[rule].why);
}

/*
 * sentences_en.c: what paper and instructions say, in English.
 */
#include "language/language.h"

static const mus__language_row sentences_en[] = {
    {"buttons.many", "{0} buttons"},
    {"buttons.one", "{0} button"},
    {"cloth.wide", "{0} wide: {1}"},
    {"count.main", "{0}"},
    {"count.other", "{0} {1}"},
    {"cut.fold", "Cut {0} on fold"},
    {"cut.mirrored", "Cut {0} mirrored"},
    {"cut.plain", "Cut {0}"},
    {"depth", "{0} mm"},
    {"ease.ease", "ease in the {0} from {1}"},
    {"ease.gather", "gather the {0} from {1}: two rows of long stitches within the allowance, drawn up evenly"},
    {"ease.pleats", "pleats shorten the {0} from {1}"},
    {"ease.rib", "stretch the {0} from {1} to {2}"},
    {"fabric.cotton", "cotton cloth"},
    {"fabric.denim", "denim"},
    {"fabric.jersey", "jersey, a knit that stretches"},
    {"fabric.pc_twill", "twill of cotton and polyester"},
    {"fabric.polyester", "light polyester that flows"},
    {"fabric.satin", "satin"},
    {"fabric.shirting", "shirting"},
    {"fabric.tropical", "light wool suiting"},
    {"fabric.wool", "wool cloth"},
    {"facts.cover.many", "{0} pages after this one, {1} x {2}, scale 1:1"},
    {"facts.cover.one", "{0} page after this one, {1} x {2}, scale 1:1"},
    {"facts.many", "{0} pages, {1} x {2}, scale 1:1"},
    {"facts.one", "{0} page, {1} x {2}, scale 1:1"},
    {"facts.person", "For {0}.  {1}"},
    {"head.asked", "asked"},
    {"head.cloth", "Cloth"},
    {"head.drafted", "Drafted to these measures"},
    {"head.error", "error"},
    {"head.made", "made"},
    {"head.measures", "measure"},
    {"head.notions", "Notions"},
    {"head.pieces", "Pieces"},
    {"head.sewing", "Sewing, on the lines of short dashes, right sides together unless a step says otherwise"},
    {"layout.fold", "fold edge"},
    {"layout.layers", "two layers"},
    {"layout.length", "Cloth needed: {0} m, {1} mm wide"},
    {"layout.nap", "with nap: all pieces in one direction"},
    {"layout.on_fold", "on the fold"},
    {"layout.selvedge", "selvedge"},
    {"layout.selvedges", "selvedges"},
    {"layout.spare", "two layers, one to spare"},
    {"layout.title", "Cutting layout"},
    {"layout.turned", "turned over"},
    {"length", "{0}.{1} cm"},
    {"line.alike", "left and right alike"},
    {"line.at", "{0} to {1} at the {2}"},
    {"line.dart.many", "{0}: {1} darts of {2}"},
    {"line.dart.one", "{0}: {1} dart of {2}"},
    {"line.edges", "{0} ({1}) to {2} ({3})"},
    {"line.folded", "first fold it along its line, wrong sides together, and sew both its edges on"},
    {"line.onto", "{0} onto {1}"},
    {"line.panels", "{0} to {1}"},
    {"line.pleat.many", "{0}: {1} pleats of {2}"},
    {"line.pleat.one", "{0}: {1} pleat of {2}"},
    {"line.same_panel", "{0}: {1} to {2}"},
    {"line.slit", "from one edge of the slit to the other"},
    {"line.slot",
     "in the left one leave the slot open, from the waist up to the three notches: the long tie goes out there"},
    {"line.zip", "set in the zip: {0}"},
    {"list.colon", "{0}: {1}"},
    {"list.comma", ", "},
    {"list.semicolon", "; "},
    {"mark.biceps", "biceps"},
    {"mark.button", "button"},
    {"mark.buttonhole", "buttonhole"},
    {"mark.flap", "flap"},
    {"mark.fold", "fold"},
    {"mark.grain", "grain"},
    {"mark.interfacing", "interfacing"},
    {"mark.kangaroo pocket", "kangaroo pocket"},
    {"mark.placket", "placket"},
    {"mark.pleat", "pleat"},
    {"mark.pocket", "pocket"},
    {"mark.pocket opening", "pocket opening"},
    {"mark.slit", "slit"},
    {"mark.slot", "slot"},
    {"mark.stand end", "end of the stand"},
    {"mark.tie", "tie"},
    {"mark.underlap", "underlap"},
    {"mark.welt", "welt"},
    {"mark.zip", "zip"},
    {"material.elastic", "elastic"},
    {"material.interfacing", "interfacing"},
    {"material.lining", "lining"},
    {"material.main", "main cloth"},
    {"material.rib", "rib"},
    {"measure.derived", "derived"},
    {"measure.volume", "volume {0} l, {1} ms"},
    {"metres", "{0}.{1} m"},
    {"notches.many", "{0} notches"},
    {"notches.one", "{0} notch"},
    {"notes.made_for", "Made for: {0}"},
    {"notion.elastic", "elastic, {0} x {1}, {2} wide"},
    {"notion.fly", "a zip of {0} for the fly"},
    {"notion.zip", "a zip for an opening of {0}"},
    {"paper.allowance", "Seam allowance included: {0} mm"},
    {"paper.allowance_at", "Seam allowance included: {0}"},
    {"paper.cut", "Solid line: cut."},
    {"paper.cut_sizes", "Thick line, in the dashes of your size: cut."},
    {"paper.dart", "fold here"},
    {"paper.edge", "{0} {1} mm"},
    {"paper.empty", "Places without a line have no page: {0}."},
    {"paper.fold", "place on fold"},
    {"paper.inner", "inner square: 100 mm"},
    {"paper.measure", "measure: print at 100 %, scale 1:1"},
    {"paper.more", "and {0} more"},
    {"paper.no_allowance", "No seam allowance included"},
    {"paper.none_at", "no allowance: {0}"},
    {"paper.other_edges", "other edges"},
    {"paper.outer", "outer square: 4 inch"},
    {"paper.person", "For {0}"},
    {"paper.piece", "Piece {0} of {1}"},
    {"paper.scale", "Scale 1:1"},
    {"paper.sizes", "Sizes {0}"},
    {"paper.step.1", "Print at 100 %, never \"fit to page\", and measure both squares before cutting."},
    {"paper.step.2", "Cut off the left and upper margins along the frame."},
    {"paper.step.3", "Lay each page on its neighbours, frame on frame, so that the diamonds are whole, and tape it."},
    {"paper.step.4",
     "{0} Short dashes: sew; at a hem: fold up. Long dashes: what their word says, as a fold or a place. "
     "Cross: a point to mark. Double arrow: grain. Short strokes on the cut line: notches; three together: end "
     "of a zip or opening, at the middle one."},
    {"paper.step.5",
     "Cross in a line: buttonhole of the upper front and button of the under front. The upper front is the left "
     "one for men, the right one for women."},
    {"paper.tile", "{0}  page {1} of {2}  scale 1:1"},
    {"sewing.general",
     "Neaten the raw edges and press each seam before another crosses it; sew a knit with a stretch or a "
     "zigzag stitch. Turn the raw edge of a hem that frays under first."},
    {"step.buttons", "Work the buttonholes in the part that lies above and sew the buttons on the part below:"},
    {"step.close", "Close:"},
    {"step.close_in_one", "Close, in one go:"},
    {"step.darts", "Sew the darts:"},
    {"step.darts_pleats", "Sew the darts and fold the pleats:"},
    {"step.elastic", "Stretch the elastic and sew it inside along the {0}."},
    {"step.faced",
     "Finish the {0} of {1}, {2} in all, with: {3}, sewn on right sides together, turned inside and pressed."},
    {"step.faced_joined",
     "Finish the {0} of {1}, {2} in all, with: {3}, joined as those are, sewn on right sides together, turned "
     "inside and pressed. Ends at an opening are turned under."},
    {"step.faced_rib",
     "Finish the {0} of {1}, {2} in all, with: {3}, {4} long. Sew its ends to a ring, fold it along its line, "
     "wrong sides together, and sew both its edges on, right sides together, stretched evenly from notch to "
     "notch."},
    {"step.flap",
     "Flap pockets, from {0}: sew each two layers of a flap together on three sides and turn it; fold each "
     "welt. Sew the welt to the lower line of its place and the flap to the upper one, each with a layer of "
     "the bag; cut between them, into the corners, turn the bag in and sew its layers to each other."},
    {"step.fly",
     "Fly, from {0}, which is how the zip below is set in: sew the facing to the left front's edge of the "
     "opening and turn it in. Fold the shield lengthwise, right sides together, sew its lower end and turn it, "
     "and lay it under the right front's edge, one tape of the zip between them, and stitch. Sew the other "
     "tape to the facing alone, and topstitch the left front along the round edge of the facing."},
    {"step.fold",
     "Finish the {0} of {1}, {2} in all: fold along the line \"{3}\", right sides together, sew across the "
     "ends that are open, an underlap at its mark and along below it, and turn; turn the raw edge under and "
     "stitch it on the seam."},
    {"step.fold_elastic",
     "Finish the {0} of {1}, {2} in all: fold along the line \"{3}\" to the inside, turn the raw edge under "
     "and stitch it on the seam, with a gap; draw the elastic in, sew its ends together edge to edge and close "
     "the gap."},
    {"step.front_pocket",
     "Front pockets, from {0}: cut the front away along the line \"{1}\", with a seam allowance beyond it. Sew "
     "one layer of the bag to that edge, right sides together, cut it away likewise, turn it in and topstitch. "
     "Sew the facing to the other layer, lay it under the opening and sew the layers to each other round their "
     "inner edge."},
    {"step.fuse", "Fuse the interfacing to: {0}."},
    {"step.fuse_line", "Fuse the {1} to the wrong side of: {0}, the lines \"{2}\" on each other."},
    {"step.hem", "Finish the {0} of {1}, {2} in all: turn {3} to the wrong side and stitch."},
    {"step.hem_elastic",
     "Finish the {0} of {1}, {2} in all: turn {3} to the wrong side and stitch, with a gap; draw the elastic "
     "in, sew its ends together edge to edge and close the gap."},
    {"step.lay_on", "Hem the upper edge, turn the other edges in, lay on and stitch round, open above:"},
    {"step.layers",
     "Second layers: {0}. Sew them to each other as the first ones, lay them on these, right sides together, "
     "and sew along: {1}. Turn them, turn the last edge under and sew it over its seam by hand."},
    {"step.layers_first",
     "Sew the layers of {0} to each other, right sides together, along: {1}. Turn and press; from here on they "
     "are one, and what is seen in wear lies outside."},
    {"step.linings",
     "Linings: {0}. Cut away what facings and the folded stand cover, but for 2 cm, and sew the pieces to each "
     "other as those of the cloth. Lay the lining in, wrong sides together, turn its edges under by 1 cm and "
     "sew them by hand to the inner edges of facings, stand and hems."},
    {"step.loop",
     "Fold the strip in three lengthwise and stitch it along both edges; cut it in five equal loops and sew "
     "them over the band at the centre back, at the sides and at the middle of each front: {0}."},
    {"step.over", "Over the seam of the {0}: {1}, sewn on right sides together, turned inside and pressed."},
    {"step.over_joined",
     "Over the seam of the {0}: {1}, joined as the pieces there are, sewn on right sides together, turned "
     "inside and pressed. Ends at an opening are turned under."},
    {"step.over_rib",
     "Over the seam of the {0}: {1}, {2} long. Sew its ends to a ring, fold it along its line, wrong sides "
     "together, and sew both its edges on, right sides together, stretched evenly from notch to notch."},
    {"step.part", "Make up and sew on: {0}."},
    {"step.patch", "Hem the upper edge of the {1}, turn the others in, and stitch it along its line on: {0}."},
    {"step.placket", "Fold {1} at the {2} to the wrong side and stitch: {0}."},
    {"step.placket_line",
     "Fold {1} at the {2} to the wrong side, along the line \"{3}\", and press: {0}. Where it ends at an edge "
     "that is faced or hemmed later, fold it to the right side over that finish, sew across with the edge and "
     "turn it back; then stitch it down."},
    {"step.pleats", "Fold the pleats along their lines and hold them within the allowance: {0}."},
    {"step.pouch",
     "Hem the openings of the {1}, turn the other edges in, and stitch these along their line on: {0}. An edge "
     "that lies on a seam stays flat and is caught in it."},
    {"step.sew", "Sew:"},
    {"step.sew_in_one", "Sew, in one go:"},
    {"step.sleeve_placket",
     "Cut the slit of the sleeve along its line and sew to both its edges in one go: {0}. Fold it over the raw "
     "edge and stitch, sew across its fold at the top of the slit, and press the half towards the front under."},
    {"step.stand",
     "Second layer of {0}: lay it on the first one, right sides together, what is sewn to its upper edge "
     "between them, and sew along the upper edge and at both ends along the lines \"{2}\", which meet the "
     "folds of the fronts. Turn it; the neck seam goes on to those folds; turn the lower edge under and sew it "
     "over the neck seam by hand."},
    {"step.tie_make", "Fold lengthwise, stitch the long edge and one end, turn and press: {0}."},
    {"step.ties",
     "Sew the short tie to the end of the left front, which lies on top, and the long tie to the end of the "
     "right front, right sides together: the facing is sewn over them. To wear it, lead the long tie out "
     "through the slot and round the waist, and tie it to the short one:"},
    {"step.turn", "Finish the {0} of {1}, {2} in all: turn to the wrong side and stitch."},
    {"step.turn_elastic",
     "Finish the {0} of {1}, {2} in all: turn to the wrong side and stitch, with a gap; draw the elastic in, "
     "sew its ends together edge to edge and close the gap."},
    {"step.underlap",
     "The underlap of {0} reaches {1} beyond the seam line, as far as its mark: its layers are sewn to each "
     "other there and along its lower edge, and not on the seam line itself."},
    {"step.welt",
     "Welt pockets, from {0}: fold each welt, right sides together, sew its ends and turn it. Sew it to the "
     "lower line of its place with one layer of the bag on it, and the other layer to the upper line; cut "
     "between them, into the corners, turn the bag in, stitch the ends of the welt up and sew the layers of "
     "the bag to each other."},
    {"unit.degree", "deg"},
};

const mus__language_list mus__sentences_en = {sentences_en, (int32_t)(sizeof sentences_en / sizeof sentences_en[0])};

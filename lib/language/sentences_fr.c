/*
 * sentences_fr.c: what paper and instructions say, in French.
 */
#include "language/language.h"

static const mus__language_row sentences_fr[] = {
    {"buttons.many", "{0} boutons"},
    {"buttons.one", "{0} bouton"},
    {"cloth.wide", "{0} de large : {1}"},
    {"count.main", "{0} fois"},
    {"count.other", "{0} fois en {1}"},
    {"cut.fold", "Couper {0} au pli"},
    {"cut.mirrored", "Couper {0} en vis-à-vis"},
    {"cut.plain", "Couper {0}"},
    {"depth", "{0} mm"},
    {"ease.ease", "soutenir : {0}, {1}"},
    {"ease.gather", "froncer : {0}, {1}, par deux lignes de grands points dans la marge, tirées régulièrement"},
    {"ease.pleats", "raccourci par les plis : {0}, {1}"},
    {"ease.rib", "étirer : {0}, de {1} à {2}"},
    {"fabric.cotton", "toile de coton"},
    {"fabric.denim", "denim"},
    {"fabric.jersey", "jersey, une maille extensible"},
    {"fabric.pc_twill", "sergé de coton et polyester"},
    {"fabric.polyester", "polyester léger et fluide"},
    {"fabric.satin", "satin"},
    {"fabric.shirting", "tissu de chemise"},
    {"fabric.tropical", "lainage léger de costume"},
    {"fabric.wool", "drap de laine"},
    {"facts.cover.many", "{0} pages après celle-ci, {1} x {2}, échelle 1:1"},
    {"facts.cover.one", "{0} page après celle-ci, {1} x {2}, échelle 1:1"},
    {"facts.many", "{0} pages, {1} x {2}, échelle 1:1"},
    {"facts.one", "{0} page, {1} x {2}, échelle 1:1"},
    {"facts.person", "Pour {0}.  {1}"},
    {"head.asked", "demandé"},
    {"head.cloth", "Tissu"},
    {"head.drafted", "Tracé d’après ces mesures"},
    {"head.error", "écart"},
    {"head.made", "obtenu"},
    {"head.measures", "mesure"},
    {"head.notions", "Mercerie"},
    {"head.pieces", "Pièces du patron"},
    {"head.sewing",
     "Montage : piquer sur les lignes de tirets courts, endroit contre endroit sauf indication contraire"},
    {"layout.fold", "pliure"},
    {"layout.layers", "deux épaisseurs"},
    {"layout.length", "Métrage : {0} m en {1} mm de large"},
    {"layout.nap", "tissu avec sens : toutes les pièces dans la même direction"},
    {"layout.on_fold", "au pli"},
    {"layout.selvedge", "lisière"},
    {"layout.selvedges", "lisières"},
    {"layout.spare", "deux épaisseurs, une en trop"},
    {"layout.title", "Plan de coupe"},
    {"layout.turned", "retournée"},
    {"length", "{0},{1} cm"},
    {"line.alike", "à gauche comme à droite"},
    {"line.at", "{0} et {1} ({2})"},
    {"line.dart.many", "{0} : {1} pinces de {2}"},
    {"line.dart.one", "{0} : {1} pince de {2}"},
    {"line.edges", "{0} ({1}) et {2} ({3})"},
    {"line.folded", "la plier d’abord sur sa ligne, envers contre envers, et coudre ses deux bords"},
    {"line.onto", "{0} sur {1}"},
    {"line.panels", "{0} et {1}"},
    {"line.pleat.many", "{0} : {1} plis de {2}"},
    {"line.pleat.one", "{0} : {1} pli de {2}"},
    {"line.same_panel", "{0} : {1} et {2}"},
    {"line.slit", "d’un bord de la fente à l’autre"},
    {"line.slot", "à gauche, laisser ouvert le passage, de la taille aux trois crans : le long lien y sort"},
    {"line.zip", "poser la fermeture à glissière : {0}"},
    {"list.colon", "{0} : {1}"},
    {"list.comma", ", "},
    {"list.semicolon", " ; "},
    {"mark.biceps", "ligne de bras"},
    {"mark.button", "bouton"},
    {"mark.buttonhole", "boutonnière"},
    {"mark.flap", "rabat"},
    {"mark.fold", "pliure"},
    {"mark.grain", "droit fil"},
    {"mark.interfacing", "entoilage"},
    {"mark.kangaroo pocket", "poche kangourou"},
    {"mark.placket", "fente"},
    {"mark.pleat", "pli"},
    {"mark.pocket", "poche"},
    {"mark.pocket opening", "ouverture de poche"},
    {"mark.slit", "fente"},
    {"mark.slot", "passage"},
    {"mark.stand end", "bout du pied de col"},
    {"mark.tie", "lien"},
    {"mark.underlap", "sous-patte"},
    {"mark.welt", "passepoil"},
    {"mark.zip", "fermeture"},
    {"material.elastic", "élastique"},
    {"material.interfacing", "entoilage"},
    {"material.lining", "doublure"},
    {"material.main", "tissu principal"},
    {"material.rib", "bord-côte"},
    {"measure.derived", "déduit"},
    {"measure.volume", "volume {0} l, {1} ms"},
    {"metres", "{0},{1} m"},
    {"notches.many", "{0} crans"},
    {"notches.one", "{0} cran"},
    {"notes.made_for", "Prévu pour : {0}"},
    {"notion.elastic", "élastique, {0} × {1}, largeur {2}"},
    {"notion.fly", "fermeture à glissière pour la braguette, {0}"},
    {"notion.zip", "fermeture à glissière pour une ouverture de {0}"},
    {"paper.allowance", "Marges de couture comprises : {0} mm"},
    {"paper.allowance_at", "Marges de couture comprises : {0}"},
    {"paper.cut", "Trait plein : couper."},
    {"paper.cut_sizes", "Trait épais, aux tirets de votre taille : couper."},
    {"paper.dart", "plier ici"},
    {"paper.edge", "{0} {1} mm"},
    {"paper.empty", "Les cases sans ligne n'ont pas de page : {0}."},
    {"paper.fold", "pliure du tissu"},
    {"paper.inner", "carré intérieur : 100 mm"},
    {"paper.measure", "à mesurer : imprimer à 100 %, échelle 1:1"},
    {"paper.more", "et {0} de plus"},
    {"paper.no_allowance", "Marges de couture non comprises"},
    {"paper.none_at", "sans marge : {0}"},
    {"paper.other_edges", "autres bords"},
    {"paper.outer", "carré extérieur : 4 pouces"},
    {"paper.person", "Pour {0}"},
    {"paper.piece", "Pièce {0} sur {1}"},
    {"paper.scale", "Échelle 1:1"},
    {"paper.sizes", "Tailles {0}"},
    {"paper.step.1", "Imprimer à 100 %, jamais « ajuster à la page », et mesurer les deux carrés avant de couper."},
    {"paper.step.2", "Couper les marges de gauche et du haut le long du cadre."},
    {"paper.step.3",
     "Poser chaque page sur ses voisines, cadre sur cadre, de sorte que les losanges soient entiers, et coller."},
    {"paper.step.4",
     "{0} Tirets courts : coudre, ou replier un ourlet. Tirets longs : ce que dit le mot, pli ou emplacement. "
     "Croix : point à reporter. Double flèche : droit fil. Petits traits sur la ligne de coupe : crans ; "
     "trois ensemble : fin de la fermeture ou de l'ouverture, au cran du milieu."},
    {"paper.step.5",
     "Croix sur un trait : boutonnière du devant de dessus, bouton du devant de dessous. Dessus : le devant "
     "gauche pour les hommes, le droit pour les femmes."},
    {"paper.tile", "{0}  page {1} sur {2}  échelle 1:1"},
    {"sewing.general",
     "Surfiler les bords vifs et repasser chaque couture avant qu’une autre ne la croise ; coudre une maille "
     "au point extensible ou zigzag. Pour un ourlet qui s’effiloche, rentrer d’abord le bord vif."},
    {"step.buttons", "Faire les boutonnières dans la partie du dessus et coudre les boutons sur celle du dessous :"},
    {"step.close", "Fermer :"},
    {"step.close_in_one", "Fermer, en une seule fois :"},
    {"step.darts", "Coudre les pinces :"},
    {"step.darts_pleats", "Coudre les pinces et former les plis :"},
    {"step.elastic", "Étirer l’élastique et le coudre à l’intérieur ({0})."},
    {"step.faced",
     "Finir le bord ({0} : {1}, {2} en tout) avec : {3}. Piquer endroit contre endroit, rabattre à l’intérieur et "
     "repasser."},
    {"step.faced_joined",
     "Finir le bord ({0} : {1}, {2} en tout) avec : {3}. Les assembler comme ceux-ci, piquer endroit contre "
     "endroit, rabattre à l’intérieur et repasser. Les bouts à une ouverture sont rentrés."},
    {"step.faced_rib",
     "Finir le bord ({0} : {1}, {2} en tout) avec : {3}, {4} de long. Fermer en anneau, plier sur sa ligne, "
     "envers contre envers, et piquer ses deux bords endroit contre endroit, en étirant également de cran à "
     "cran."},
    {"step.flap",
     "Poches à rabat, avec {0} : assembler deux à deux les épaisseurs d’un rabat sur trois côtés et "
     "retourner ; plier chaque patte. Coudre la patte sur la ligne inférieure de son emplacement et le rabat "
     "sur la supérieure, chacun avec une épaisseur du sac ; couper entre les deux jusque dans les angles, "
     "rentrer le sac et assembler ses épaisseurs."},
    {"step.fly",
     "Braguette, avec {0} ; c’est ainsi que se pose la fermeture ci-dessous : coudre la parementure au bord "
     "d’ouverture du devant gauche et la rabattre. Plier la sous-patte en long, endroit contre endroit, "
     "coudre son bout inférieur, la retourner et la poser sous le bord du devant droit, un ruban de la "
     "fermeture entre les deux, et piquer. Coudre l’autre ruban à la seule parementure et surpiquer le "
     "devant gauche le long de son arrondi."},
    {"step.fold",
     "Finir le bord ({0} : {1}, {2} en tout) : plier sur la ligne « {3} », endroit contre endroit, fermer "
     "les bouts ouverts, une sous-patte à son repère et dessous, et retourner ; rentrer le bord vif et le "
     "piquer sur la couture."},
    {"step.fold_elastic",
     "Finir le bord ({0} : {1}, {2} en tout) : plier vers l’intérieur sur la ligne « {3} », rentrer le "
     "bord vif et le piquer sur la couture en laissant une ouverture ; enfiler l’élastique, coudre ses "
     "bouts bord à bord et fermer."},
    {"step.front_pocket",
     "Poches de devant, avec {0} : couper le devant le long de la ligne « {1} » en laissant une marge de "
     "couture. Coudre une épaisseur du sac à ce bord, endroit contre endroit, la couper de même, la rentrer "
     "et surpiquer. Coudre la parementure sur l’autre épaisseur, la glisser sous l’ouverture et assembler "
     "les deux le long de leur bord intérieur."},
    {"step.fuse", "Thermocoller l’entoilage sur : {0}."},
    {"step.fuse_line", "Thermocoller {1} sur l’envers de : {0}, les lignes « {2} » l’une sur l’autre."},
    {"step.hem", "Finir le bord ({0} : {1}, {2} en tout) : replier {3} sur l’envers et piquer."},
    {"step.hem_elastic",
     "Finir le bord ({0} : {1}, {2} en tout) : replier {3} sur l’envers et piquer en laissant une ouverture "
     "; enfiler l’élastique, coudre ses bouts bord à bord et fermer."},
    {"step.lay_on", "Ourler le bord supérieur, replier les autres, poser et piquer tout autour, ouvert en haut :"},
    {"step.layers",
     "Secondes épaisseurs : {0}. Les assembler comme les premières, les poser dessus, endroit contre "
     "endroit, et coudre le long de : {1}. Retourner, rentrer le dernier bord et le coudre à la main sur sa "
     "couture."},
    {"step.layers_first",
     "Assembler les épaisseurs de {0}, endroit contre endroit, le long de : {1}. Retourner et repasser ; "
     "elles n’en font désormais qu’une, et ce que l’on voit porté est dehors."},
    {"step.linings",
     "Doublures : {0}. Couper ce que couvrent les parementures et la patte repliée, moins 2 cm, et assembler "
     "les pièces comme celles du tissu. Poser la doublure, envers contre envers, rentrer ses bords de 1 cm et "
     "les coudre à la main aux bords intérieurs des parementures, de la patte et des ourlets."},
    {"step.loop",
     "Plier la bande en trois dans la longueur et piquer ses deux bords ; couper cinq passants égaux et les "
     "coudre par-dessus la ceinture au milieu du dos, aux côtés et au milieu de chaque devant : {0}."},
    {"step.over",
     "Par-dessus la couture ({0}) : {1}. Piquer endroit contre endroit, rabattre à l’intérieur et repasser."},
    {"step.over_joined",
     "Par-dessus la couture ({0}) : {1}. Les assembler comme les pièces à cet endroit, piquer endroit contre "
     "endroit, rabattre à l’intérieur et repasser. Les bouts à une ouverture sont rentrés."},
    {"step.over_rib",
     "Par-dessus la couture ({0}) : {1}, {2} de long. Fermer en anneau, plier sur sa ligne, envers contre "
     "envers, et piquer ses deux bords endroit contre endroit, en étirant également de cran à cran."},
    {"step.part", "Préparer et coudre : {0}."},
    {"step.patch", "Ourler le bord supérieur ({1}), replier les autres bords et piquer le long du repère sur : {0}."},
    {"step.placket", "Replier {1} sur l’envers et piquer ({2}) : {0}."},
    {"step.placket_line",
     "Replier {1} sur l’envers le long de la ligne « {3} » et repasser ({2}) : {0}. Là où elle finit à "
     "un bord paré ou ourlé plus tard, la replier sur l’endroit par-dessus, coudre en travers avec le bord "
     "et la retourner ; puis la piquer."},
    {"step.pleats", "Former les plis le long des lignes et les maintenir dans la marge de couture : {0}."},
    {"step.pouch",
     "Ourler les ouvertures ({1}), replier les autres bords et piquer ceux-ci le long du repère sur : {0}. Un "
     "bord posé sur une couture reste à plat et y est pris."},
    {"step.sew", "Assembler :"},
    {"step.sew_in_one", "Assembler, en une seule fois :"},
    {"step.sleeve_placket",
     "Couper la fente de la manche le long de sa ligne et coudre à ses deux bords d’un seul trait : {0}. "
     "Rabattre sur le bord vif et piquer, coudre en travers du pli en haut de la fente et repasser la moitié "
     "avant vers l’intérieur."},
    {"step.stand",
     "Seconde épaisseur de {0} : la poser sur la première, endroit contre endroit, ce qui est cousu au bord "
     "supérieur entre les deux, et coudre le long du bord supérieur et aux deux bouts sur les lignes « {2} "
     "», qui tombent sur les plis des devants. Retourner ; la couture d’encolure va jusqu’à ces plis ; "
     "rentrer le bord inférieur et le coudre à la main sur cette couture."},
    {"step.tie_make", "Plier en longueur, piquer le long côté et un bout, retourner et repasser : {0}."},
    {"step.ties",
     "Coudre le lien court au bout du devant gauche, qui est dessus, et le lien long au bout du devant droit, "
     "endroit contre endroit : la parementure se coud par-dessus. Pour s’habiller, faire sortir le lien long "
     "par le passage, le mener autour de la taille et le nouer au court :"},
    {"step.turn", "Finir le bord ({0} : {1}, {2} en tout) : replier sur l’envers et piquer."},
    {"step.turn_elastic",
     "Finir le bord ({0} : {1}, {2} en tout) : replier sur l’envers et piquer en laissant une ouverture ; "
     "enfiler l’élastique, coudre ses bouts bord à bord et fermer."},
    {"step.underlap",
     "La sous-patte ({0}) dépasse la ligne de couture de {1}, jusqu’à son repère : ses épaisseurs sont "
     "cousues là et le long de son bord inférieur, et non sur la ligne de couture même."},
    {"step.welt",
     "Poches passepoilées, avec {0} : plier chaque patte endroit contre endroit, coudre ses bouts et "
     "retourner. La coudre sur la ligne inférieure de son emplacement avec une épaisseur du sac dessus, et "
     "l’autre épaisseur sur la ligne supérieure ; couper entre les deux jusque dans les angles, rentrer le "
     "sac, piquer les bouts de la patte vers le haut et assembler les épaisseurs du sac."},
    {"unit.degree", "°"},
};

const mus__language_list mus__sentences_fr = {sentences_fr, (int32_t)(sizeof sentences_fr / sizeof sentences_fr[0])};

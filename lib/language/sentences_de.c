/*
 * sentences_de.c: what paper and instructions say, in German.
 */
#include "language/language.h"

static const mus__language_row sentences_de[] = {
    {"buttons.many", "{0} Knöpfe"},
    {"buttons.one", "{0} Knopf"},
    {"cloth.wide", "{0} breit: {1}"},
    {"count.main", "{0}x"},
    {"count.other", "{0}x {1}"},
    {"cut.fold", "{0} im Stoffbruch zuschneiden"},
    {"cut.mirrored", "{0} gegengleich zuschneiden"},
    {"cut.plain", "{0} zuschneiden"},
    {"depth", "{0} mm"},
    {"ease.ease", "{0}: {1} einhalten"},
    {"ease.gather", "{0}: {1} einreihen, mit zwei Reihen langer Stiche in der Zugabe, gleichmäßig zusammengezogen"},
    {"ease.pleats", "{0}: {1}, durch Falten gekürzt"},
    {"ease.rib", "{0}: von {1} auf {2} dehnen"},
    {"fabric.cotton", "Baumwollstoff"},
    {"fabric.denim", "Denim"},
    {"fabric.jersey", "Jersey, ein dehnbarer Maschenstoff"},
    {"fabric.pc_twill", "Köper aus Baumwolle und Polyester"},
    {"fabric.polyester", "leichter, fließender Polyester"},
    {"fabric.satin", "Satin"},
    {"fabric.shirting", "Hemdenstoff"},
    {"fabric.tropical", "leichter Anzugstoff aus Wolle"},
    {"fabric.wool", "Wollstoff"},
    {"facts.cover.many", "{0} Seiten nach dieser, {1} x {2}, Maßstab 1:1"},
    {"facts.cover.one", "{0} Seite nach dieser, {1} x {2}, Maßstab 1:1"},
    {"facts.many", "{0} Seiten, {1} x {2}, Maßstab 1:1"},
    {"facts.one", "{0} Seite, {1} x {2}, Maßstab 1:1"},
    {"facts.person", "Für {0}.  {1}"},
    {"head.asked", "Soll"},
    {"head.cloth", "Stoff"},
    {"head.drafted", "Gezeichnet nach diesen Maßen"},
    {"head.error", "Abweichung"},
    {"head.made", "Ist"},
    {"head.measures", "Maß"},
    {"head.notions", "Kurzwaren"},
    {"head.pieces", "Schnittteile"},
    {"head.sewing", "Nähen, auf den kurz gestrichelten Linien; wenn nicht anders angegeben, rechts auf rechts"},
    {"layout.fold", "Stoffbruch"},
    {"layout.layers", "zwei Lagen"},
    {"layout.length", "Stoffverbrauch: {0} m, {1} mm breit"},
    {"layout.nap", "mit Strich: alle Teile in einer Richtung"},
    {"layout.on_fold", "im Stoffbruch"},
    {"layout.selvedge", "Webkante"},
    {"layout.selvedges", "Webkanten"},
    {"layout.spare", "zwei Lagen, eine übrig"},
    {"layout.title", "Zuschneideplan"},
    {"layout.turned", "gewendet"},
    {"length", "{0},{1} cm"},
    {"line.alike", "links und rechts gleich"},
    {"line.at", "{0} an {1} ({2})"},
    {"line.dart.many", "{0}: {1} Abnäher, je {2}"},
    {"line.dart.one", "{0}: {1} Abnäher, {2}"},
    {"line.edges", "{0} ({1}) an {2} ({3})"},
    {"line.folded", "vorher an der Linie links auf links falten und beide Kanten annähen"},
    {"line.onto", "{0} auf {1}"},
    {"line.panels", "{0} an {1}"},
    {"line.pleat.many", "{0}: {1} Falten, je {2}"},
    {"line.pleat.one", "{0}: {1} Falte, {2}"},
    {"line.same_panel", "{0}: {1} an {2}"},
    {"line.slit", "von einer Kante des Schlitzes zur anderen"},
    {"line.slot",
     "in der linken den Durchlass offen lassen, von der Taille bis zu den drei Passzeichen: dort tritt das "
     "lange Bindeband aus"},
    {"line.zip", "Reißverschluss einnähen: {0}"},
    {"list.colon", "{0}: {1}"},
    {"list.comma", ", "},
    {"list.semicolon", "; "},
    {"mark.biceps", "Oberarmlinie"},
    {"mark.button", "Knopf"},
    {"mark.buttonhole", "Knopfloch"},
    {"mark.flap", "Patte"},
    {"mark.fold", "Umbruch"},
    {"mark.grain", "Fadenlauf"},
    {"mark.interfacing", "Einlage"},
    {"mark.kangaroo pocket", "Kängurutasche"},
    {"mark.placket", "Schlitz"},
    {"mark.pleat", "Falte"},
    {"mark.pocket", "Tasche"},
    {"mark.pocket opening", "Tascheneingriff"},
    {"mark.slit", "Schlitz"},
    {"mark.slot", "Durchlass"},
    {"mark.stand end", "Ende des Stegs"},
    {"mark.tie", "Bindeband"},
    {"mark.underlap", "Untertritt"},
    {"mark.welt", "Leiste"},
    {"mark.zip", "Reißverschluss"},
    {"material.elastic", "Gummiband"},
    {"material.interfacing", "Einlage"},
    {"material.lining", "Futter"},
    {"material.main", "Oberstoff"},
    {"material.rib", "Bündchenstoff"},
    {"measure.derived", "abgeleitet"},
    {"measure.volume", "Volumen {0} l, {1} ms"},
    {"metres", "{0},{1} m"},
    {"notches.many", "{0} Passzeichen"},
    {"notches.one", "{0} Passzeichen"},
    {"notes.made_for", "Gedacht für: {0}"},
    {"notion.elastic", "Gummiband, {0} x {1}, {2} breit"},
    {"notion.fly", "Reißverschluss für den Schlitz, {0}"},
    {"notion.zip", "Reißverschluss für eine Öffnung von {0}"},
    {"paper.allowance", "Nahtzugabe enthalten: {0} mm"},
    {"paper.allowance_at", "Nahtzugabe enthalten: {0}"},
    {"paper.cut", "Durchgezogene Linie: zuschneiden."},
    {"paper.cut_sizes", "Dicke Linie, gestrichelt wie die eigene Größe: zuschneiden."},
    {"paper.dart", "hier falten"},
    {"paper.edge", "{0} {1} mm"},
    {"paper.empty", "Felder ohne Linie haben keine Seite: {0}."},
    {"paper.fold", "Stoffbruch"},
    {"paper.inner", "inneres Quadrat: 100 mm"},
    {"paper.measure", "nachmessen: mit 100 % drucken, Maßstab 1:1"},
    {"paper.more", "und {0} weitere"},
    {"paper.no_allowance", "Ohne Nahtzugabe"},
    {"paper.none_at", "ohne Zugabe: {0}"},
    {"paper.other_edges", "übrige Kanten"},
    {"paper.outer", "äußeres Quadrat: 4 Zoll"},
    {"paper.person", "Für {0}"},
    {"paper.piece", "Teil {0} von {1}"},
    {"paper.scale", "Maßstab 1:1"},
    {"paper.sizes", "Größen {0}"},
    {"paper.step.1", "Mit 100 % drucken, nie „an Seite anpassen“, und vor dem Zuschneiden beide Quadrate nachmessen."},
    {"paper.step.2", "Den linken und den oberen Rand am Rahmen entlang abschneiden."},
    {"paper.step.3", "Jede Seite Rahmen auf Rahmen an ihre Nachbarn legen, bis die Rauten ganz sind, und festkleben."},
    {"paper.step.4",
     "{0} Kurz gestrichelt: nähen, an einem Saum umschlagen. Lang gestrichelt: was das Wort daran sagt, etwa "
     "Umbruch oder Platz. Kreuz: Punkt zum Anzeichnen. Doppelpfeil: Fadenlauf. Kurze Striche an der "
     "Schnittlinie: Passzeichen; drei nebeneinander: Ende von Reißverschluss oder Öffnung, beim mittleren."},
    {"paper.step.5",
     "Kreuz auf einer Linie: Knopfloch im oberen Vorderteil, Knopf auf dem unteren. Oben liegt bei Herren das "
     "linke, bei Damen das rechte Vorderteil."},
    {"paper.tile", "{0}  Seite {1} von {2}  Maßstab 1:1"},
    {"sewing.general",
     "Schnittkanten versäubern und jede Naht bügeln, bevor eine andere sie kreuzt; Maschenstoff mit Stretch- "
     "oder Zickzackstich nähen. Bei Säumen, die ausfransen, zuerst die Schnittkante einschlagen."},
    {"step.buttons", "Knopflöcher in den oben liegenden Teil arbeiten und Knöpfe auf den unteren nähen:"},
    {"step.close", "Schließen:"},
    {"step.close_in_one", "In einem Zug schließen:"},
    {"step.darts", "Abnäher nähen:"},
    {"step.darts_pleats", "Abnäher nähen und Falten legen:"},
    {"step.elastic", "Gummiband dehnen und innen aufnähen ({0})."},
    {"step.faced",
     "Kante versäubern – {0}: {1}, insgesamt {2}. {3} rechts auf rechts annähen, nach innen wenden und bügeln."},
    {"step.faced_joined",
     "Kante versäubern – {0}: {1}, insgesamt {2}. {3} wie diese zusammennähen, rechts auf rechts annähen, "
     "nach innen wenden und bügeln. Enden an einer Öffnung werden eingeschlagen."},
    {"step.faced_rib",
     "Kante einfassen – {0}: {1}, insgesamt {2}. {3}, {4} lang. Zum Ring schließen, an der Linie links auf "
     "links falten und beide Kanten rechts auf rechts annähen, von Passzeichen zu Passzeichen gleichmäßig "
     "gedehnt."},
    {"step.flap",
     "Pattentaschen aus {0}: je zwei Lagen einer Patte an drei Seiten zusammennähen und wenden; jede Leiste "
     "falten. Die Leiste an die untere Linie ihres Platzes nähen, die Patte an die obere, jede mit einer Lage "
     "des Beutels; dazwischen bis in die Ecken einschneiden, den Beutel nach innen wenden und seine Lagen "
     "zusammennähen."},
    {"step.fly",
     "Hosenschlitz aus {0}; so wird der Reißverschluss weiter unten eingesetzt: den Beleg an die Schlitzkante "
     "des linken Vorderteils nähen und nach innen wenden. Den Untertritt längs rechts auf rechts falten, das "
     "untere Ende nähen, wenden, unter die Kante des rechten Vorderteils legen, ein Band des "
     "Reißverschlusses dazwischen, und steppen. Das andere Band nur auf den Beleg nähen und das linke "
     "Vorderteil entlang der Rundung des Belegs absteppen."},
    {"step.fold",
     "Kante säumen – {0}: {1}, insgesamt {2}. An der Linie „{3}“ rechts auf rechts falten, offene Enden "
     "zunähen, einen Untertritt an seiner Markierung und unten, und wenden; die Schnittkante einschlagen und "
     "auf der Naht feststeppen."},
    {"step.fold_elastic",
     "Kante säumen – {0}: {1}, insgesamt {2}. An der Linie „{3}“ nach innen falten, die Schnittkante "
     "einschlagen und auf der Naht feststeppen, dabei eine Öffnung lassen; Gummiband einziehen, seine Enden "
     "Kante an Kante zusammennähen und die Öffnung schließen."},
    {"step.front_pocket",
     "Vordere Taschen aus {0}: das Vorderteil an der Linie „{1}“ mit einer Nahtzugabe wegschneiden. Eine "
     "Lage des Beutels rechts auf rechts an diese Kante nähen, ebenso wegschneiden, nach innen wenden und "
     "absteppen. Den Beleg auf die andere Lage nähen, sie unter den Eingriff legen und die Lagen an ihrer "
     "inneren Kante zusammennähen."},
    {"step.fuse", "Einlage aufbügeln: {0}."},
    {"step.fuse_line", "{1} aufbügeln, auf die linke Seite: {0}; die Linien „{2}“ liegen aufeinander."},
    {"step.hem", "Kante säumen – {0}: {1}, insgesamt {2}. {3} nach innen umschlagen und feststeppen."},
    {"step.hem_elastic",
     "Kante säumen – {0}: {1}, insgesamt {2}. {3} nach innen umschlagen und feststeppen, dabei eine "
     "Öffnung lassen; Gummiband einziehen, seine Enden Kante an Kante zusammennähen und die Öffnung "
     "schließen."},
    {"step.lay_on", "Obere Kante säumen, die übrigen einschlagen, auflegen und feststeppen, oben offen:"},
    {"step.layers",
     "Zweite Lagen: {0}. Wie die ersten zusammennähen, rechts auf rechts auf diese legen und nähen entlang: "
     "{1}. Wenden, die letzte Kante einschlagen und von Hand über ihre Naht nähen."},
    {"step.layers_first",
     "Die Lagen rechts auf rechts zusammennähen: {0}, entlang: {1}. Wenden und bügeln; von hier an sind sie "
     "eins, und was man beim Tragen sieht, liegt außen."},
    {"step.linings",
     "Futter: {0}. Wegschneiden, was Belege und der umgelegte Untertritt bedecken, bis auf 2 cm, und die Teile "
     "wie die des Oberstoffs zusammennähen. Links auf links einlegen, die Kanten 1 cm einschlagen und von "
     "Hand an die inneren Kanten von Belegen, Knopfleiste und Säumen nähen."},
    {"step.loop",
     "Streifen längs dreifach falten und an beiden Kanten steppen; in fünf gleich lange Schlaufen schneiden "
     "und in der hinteren Mitte, an den Seiten und in der Mitte jedes Vorderteils über den Bund nähen: {0}."},
    {"step.over", "Über der Naht – {0}: {1} rechts auf rechts annähen, nach innen wenden und bügeln."},
    {"step.over_joined",
     "Über der Naht – {0}: {1} wie die Teile dort zusammennähen, rechts auf rechts annähen, nach innen "
     "wenden und bügeln. Enden an einer Öffnung werden eingeschlagen."},
    {"step.over_rib",
     "Über der Naht – {0}: {1}, {2} lang. Zum Ring schließen, an der Linie links auf links falten und "
     "beide Kanten rechts auf rechts annähen, von Passzeichen zu Passzeichen gleichmäßig gedehnt."},
    {"step.part", "Fertig arbeiten und annähen: {0}."},
    {"step.patch", "Obere Kante säumen ({1}), die übrigen Kanten einschlagen und an der Linie aufsteppen auf: {0}."},
    {"step.placket", "{1} nach innen umschlagen und feststeppen ({2}): {0}."},
    {"step.placket_line",
     "{1} an der Kante ({2}) entlang der Linie „{3}“ nach links falten und bügeln: {0}. Wo er an einer "
     "Kante endet, die später belegt oder gesäumt wird, ihn darüber nach rechts falten, mit der Kante "
     "übersteppen und wenden; dann feststeppen."},
    {"step.pleats", "Falten entlang der Linien legen und in der Nahtzugabe fixieren: {0}."},
    {"step.pouch",
     "Die Eingriffe säumen ({1}), die übrigen Kanten einschlagen und an der Linie aufsteppen auf: {0}. Eine "
     "Kante, die auf einer Naht liegt, bleibt flach und wird mitgefasst."},
    {"step.sew", "Nähen:"},
    {"step.sew_in_one", "In einem Zug nähen:"},
    {"step.sleeve_placket",
     "Den Ärmelschlitz an seiner Linie einschneiden und an beide Kanten in einem Zug nähen: {0}. Über die "
     "Schnittkante falten und steppen, oben am Schlitz quer über den Bruch nähen und die vordere Hälfte "
     "nach innen bügeln."},
    {"step.stand",
     "Zweite Lage von {0}: rechts auf rechts auf die erste legen, was an ihrer oberen Kante angenäht ist, "
     "dazwischen, und entlang der oberen Kante und an beiden Enden auf den Linien „{2}“ nähen, die auf "
     "die Umbrüche der Vorderteile treffen. Wenden; die Halsnaht geht bis zu diesen Umbrüchen weiter; die "
     "untere Kante einschlagen und von Hand über die Halsnaht nähen."},
    {"step.tie_make", "Der Länge nach falten, die lange Kante und ein Ende nähen, wenden und bügeln: {0}."},
    {"step.ties",
     "Das kurze Bindeband rechts auf rechts an das Ende des linken Vorderteils nähen, das oben liegt, das "
     "lange an das Ende des rechten: der Beleg wird darübergenäht. Beim Tragen das lange Band durch den "
     "Durchlass und um die Taille führen und mit dem kurzen binden:"},
    {"step.turn", "Kante säumen – {0}: {1}, insgesamt {2}. Nach innen umschlagen und feststeppen."},
    {"step.turn_elastic",
     "Kante säumen – {0}: {1}, insgesamt {2}. Nach innen umschlagen und feststeppen, dabei eine Öffnung "
     "lassen; Gummiband einziehen, seine Enden Kante an Kante zusammennähen und die Öffnung schließen."},
    {"step.underlap",
     "Der Untertritt ({0}) reicht {1} über die Nahtlinie hinaus, bis zu seiner Markierung: dort und an seiner "
     "unteren Kante werden seine Lagen zusammengenäht, auf der Nahtlinie selbst nicht."},
    {"step.welt",
     "Leistentaschen aus {0}: jede Leiste rechts auf rechts falten, die Enden nähen und wenden. An die untere "
     "Linie ihres Platzes nähen, eine Lage des Beutels darauf, die andere Lage an die obere Linie; dazwischen "
     "bis in die Ecken einschneiden, den Beutel nach innen wenden, die Enden der Leiste hochsteppen und die "
     "Lagen des Beutels zusammennähen."},
    {"unit.degree", "°"},
};

const mus__language_list mus__sentences_de = {sentences_de, (int32_t)(sizeof sentences_de / sizeof sentences_de[0])};

/*
 * sentences_es.c: what paper and instructions say, in Spanish.
 */
#include "language/language.h"

static const mus__language_row sentences_es[] = {
    {"buttons.many", "{0} botones"},
    {"buttons.one", "{0} botón"},
    {"cloth.wide", "{0} de ancho: {1}"},
    {"count.main", "{0} ×"},
    {"count.other", "{0} × {1}"},
    {"cut.fold", "Cortar {0} al doblez"},
    {"cut.mirrored", "Cortar {0} en espejo"},
    {"cut.plain", "Cortar {0}"},
    {"depth", "{0} mm"},
    {"ease.ease", "embeber: {0}, {1}"},
    {"ease.gather", "fruncir: {0}, {1}, con dos hileras de puntadas largas en el margen, recogidas por igual"},
    {"ease.pleats", "acortado por los pliegues: {0}, {1}"},
    {"ease.rib", "estirar: {0}, de {1} a {2}"},
    {"fabric.cotton", "tela de algodón"},
    {"fabric.denim", "tela vaquera"},
    {"fabric.jersey", "punto de jersey elástico"},
    {"fabric.pc_twill", "sarga de algodón y poliéster"},
    {"fabric.polyester", "poliéster ligero y fluido"},
    {"fabric.satin", "raso"},
    {"fabric.shirting", "tela de camisa"},
    {"fabric.tropical", "lana fría para trajes"},
    {"fabric.wool", "paño de lana"},
    {"facts.cover.many", "{0} páginas después de esta, {1} x {2}, escala 1:1"},
    {"facts.cover.one", "{0} página después de esta, {1} x {2}, escala 1:1"},
    {"facts.many", "{0} páginas, {1} x {2}, escala 1:1"},
    {"facts.one", "{0} página, {1} x {2}, escala 1:1"},
    {"facts.person", "Para {0}.  {1}"},
    {"head.asked", "pedido"},
    {"head.cloth", "Tela"},
    {"head.drafted", "Trazado según estas medidas"},
    {"head.error", "error"},
    {"head.made", "obtenido"},
    {"head.measures", "medida"},
    {"head.notions", "Mercería"},
    {"head.pieces", "Piezas del patrón"},
    {"head.sewing",
     "Confección: coser por las líneas de trazos cortos, derecho con derecho salvo que se indique otra cosa"},
    {"layout.fold", "doblez"},
    {"layout.layers", "dos capas"},
    {"layout.length", "Tela necesaria: {0} m de {1} mm de ancho"},
    {"layout.nap", "tela con sentido: todas las piezas en la misma dirección"},
    {"layout.on_fold", "al doblez"},
    {"layout.selvedge", "orillo"},
    {"layout.selvedges", "orillos"},
    {"layout.spare", "dos capas, una sobra"},
    {"layout.title", "Plano de corte"},
    {"layout.turned", "vuelta"},
    {"length", "{0},{1} cm"},
    {"line.alike", "igual a izquierda y derecha"},
    {"line.at", "{0} con {1} ({2})"},
    {"line.dart.many", "{0}: {1} pinzas de {2}"},
    {"line.dart.one", "{0}: {1} pinza de {2}"},
    {"line.edges", "{0} ({1}) con {2} ({3})"},
    {"line.folded", "doblarlo antes por su línea, revés con revés, y coser sus dos bordes"},
    {"line.onto", "{0} sobre {1}"},
    {"line.panels", "{0} con {1}"},
    {"line.pleat.many", "{0}: {1} pliegues de {2}"},
    {"line.pleat.one", "{0}: {1} pliegue de {2}"},
    {"line.same_panel", "{0}: {1} con {2}"},
    {"line.slit", "de un borde de la abertura al otro"},
    {"line.slot",
     "en la izquierda dejar abierta la ranura, desde la cintura hasta los tres piquetes: por ella sale el lazo "
     "largo"},
    {"line.zip", "coser la cremallera: {0}"},
    {"list.colon", "{0}: {1}"},
    {"list.comma", ", "},
    {"list.semicolon", "; "},
    {"mark.biceps", "línea de brazo"},
    {"mark.button", "botón"},
    {"mark.buttonhole", "ojal"},
    {"mark.flap", "cartera"},
    {"mark.fold", "doblez"},
    {"mark.grain", "hilo"},
    {"mark.interfacing", "entretela"},
    {"mark.kangaroo pocket", "bolsillo canguro"},
    {"mark.placket", "abertura"},
    {"mark.pleat", "pliegue"},
    {"mark.pocket", "bolsillo"},
    {"mark.pocket opening", "abertura del bolsillo"},
    {"mark.slit", "abertura"},
    {"mark.slot", "ranura"},
    {"mark.stand end", "final de la tirilla"},
    {"mark.tie", "lazo"},
    {"mark.underlap", "cruce inferior"},
    {"mark.welt", "vivo"},
    {"mark.zip", "cremallera"},
    {"material.elastic", "elástico"},
    {"material.interfacing", "entretela"},
    {"material.lining", "forro"},
    {"material.main", "tela principal"},
    {"material.rib", "canalé"},
    {"measure.derived", "deducida"},
    {"measure.volume", "volumen {0} l, {1} ms"},
    {"metres", "{0},{1} m"},
    {"notches.many", "{0} piquetes"},
    {"notches.one", "{0} piquete"},
    {"notes.made_for", "Pensado para: {0}"},
    {"notion.elastic", "elástico, {0} × {1}, {2} de ancho"},
    {"notion.fly", "cremallera para la bragueta, {0}"},
    {"notion.zip", "cremallera para una abertura de {0}"},
    {"paper.allowance", "Margen de costura incluido: {0} mm"},
    {"paper.allowance_at", "Margen de costura incluido: {0}"},
    {"paper.cut", "Línea continua: cortar."},
    {"paper.cut_sizes", "Línea gruesa, con los trazos de su talla: cortar."},
    {"paper.dart", "doblar aquí"},
    {"paper.edge", "{0} {1} mm"},
    {"paper.empty", "Las casillas sin líneas no tienen página: {0}."},
    {"paper.fold", "doblez de la tela"},
    {"paper.inner", "cuadrado interior: 100 mm"},
    {"paper.measure", "medir: imprimir al 100 %, escala 1:1"},
    {"paper.more", "y {0} más"},
    {"paper.no_allowance", "Sin margen de costura"},
    {"paper.none_at", "sin margen: {0}"},
    {"paper.other_edges", "otros bordes"},
    {"paper.outer", "cuadrado exterior: 4 pulgadas"},
    {"paper.person", "Para {0}"},
    {"paper.piece", "Pieza {0} de {1}"},
    {"paper.scale", "Escala 1:1"},
    {"paper.sizes", "Tallas {0}"},
    {"paper.step.1", "Imprimir al 100 %, nunca «ajustar a la página», y medir los dos cuadrados antes de cortar."},
    {"paper.step.2", "Recortar los márgenes izquierdo y superior a lo largo del marco."},
    {"paper.step.3",
     "Colocar cada página sobre sus vecinas, marco sobre marco, de modo que los rombos queden enteros, y pegar."},
    {"paper.step.4",
     "{0} Trazos cortos: coser, o doblar un dobladillo. Trazos largos: lo que dice la palabra, como doblez o "
     "sitio. Cruz: punto que se marca. Flecha doble: hilo de la tela. Rayas cortas en la línea de corte: "
     "piquetes; tres juntos: fin de la cremallera o de la abertura, en el del medio."},
    {"paper.step.5",
     "Cruz en una línea: ojal en el delantero de encima, botón en el de debajo. Encima va el delantero izquierdo "
     "en hombres, el derecho en mujeres."},
    {"paper.tile", "{0}  página {1} de {2}  escala 1:1"},
    {"sewing.general",
     "Sobrehilar los bordes cortados y planchar cada costura antes de que otra la cruce; coser el punto con "
     "puntada elástica o zigzag. En un dobladillo que se deshilacha, remeter antes el borde cortado."},
    {"step.buttons", "Hacer los ojales en la parte de encima y coser los botones en la de debajo:"},
    {"step.close", "Cerrar:"},
    {"step.close_in_one", "Cerrar, de una sola vez:"},
    {"step.darts", "Coser las pinzas:"},
    {"step.darts_pleats", "Coser las pinzas y formar los pliegues:"},
    {"step.elastic", "Estirar el elástico y coserlo por dentro ({0})."},
    {"step.faced",
     "Rematar el borde ({0}: {1}, {2} en total) con: {3}. Coser derecho con derecho, volver hacia dentro y planchar."},
    {"step.faced_joined",
     "Rematar el borde ({0}: {1}, {2} en total) con: {3}. Unirlas como estos, coser derecho con derecho, "
     "volver hacia dentro y planchar. Los extremos en una abertura se remeten."},
    {"step.faced_rib",
     "Rematar el borde ({0}: {1}, {2} en total) con: {3}, {4} de largo. Cerrar en anillo, doblar por su "
     "línea, revés con revés, y coser sus dos bordes derecho con derecho, estirando por igual de piquete a "
     "piquete."},
    {"step.flap",
     "Bolsillos con tapeta, de {0}: unir dos a dos las capas de una tapeta por tres lados y volverla; doblar "
     "cada vivo. Coser el vivo a la línea inferior de su sitio y la tapeta a la superior, cada uno con una "
     "capa de la bolsa; cortar entre ambos hasta las esquinas, meter la bolsa y unir sus capas."},
    {"step.fly",
     "Bragueta, de {0}; así se coloca la cremallera de más abajo: coser la vista al borde de la abertura del "
     "delantero izquierdo y volverla hacia dentro. Doblar el cruce a lo largo, derecho con derecho, coser su "
     "extremo inferior, volverlo y ponerlo bajo el borde del delantero derecho con una cinta de la cremallera "
     "entre ambos y pespuntear. Coser la otra cinta solo a la vista y pespuntear el delantero izquierdo por la "
     "curva de la vista."},
    {"step.fold",
     "Rematar el borde ({0}: {1}, {2} en total): doblar por la línea «{3}», derecho con derecho, cerrar los "
     "extremos abiertos, un cruce en su marca y por debajo, y volver; remeter el borde cortado y pespuntearlo "
     "sobre la costura."},
    {"step.fold_elastic",
     "Rematar el borde ({0}: {1}, {2} en total): doblar hacia dentro por la línea «{3}», remeter el borde "
     "cortado y pespuntearlo sobre la costura dejando una abertura; pasar el elástico, coser sus extremos "
     "borde con borde y cerrar."},
    {"step.front_pocket",
     "Bolsillos delanteros, de {0}: cortar el delantero por la línea «{1}» dejando un margen de costura. "
     "Coser una capa de la bolsa a ese borde, derecho con derecho, cortarla igual, volverla hacia dentro y "
     "pespuntear. Coser la vista a la otra capa, ponerla bajo la abertura y unir las capas por su borde "
     "interior."},
    {"step.fuse", "Pegar la entretela con la plancha en: {0}."},
    {"step.fuse_line", "Pegar {1} con la plancha en el revés de: {0}, con las líneas «{2}» una sobre otra."},
    {"step.hem", "Rematar el borde ({0}: {1}, {2} en total): doblar {3} hacia el revés y pespuntear."},
    {"step.hem_elastic",
     "Rematar el borde ({0}: {1}, {2} en total): doblar {3} hacia el revés y pespuntear dejando una abertura; "
     "pasar el elástico, coser sus extremos borde con borde y cerrar."},
    {"step.lay_on",
     "Hacer el dobladillo de arriba, doblar los demás bordes, colocar encima y pespuntear, abierto por arriba:"},
    {"step.layers",
     "Segundas capas: {0}. Unirlas entre sí como las primeras, ponerlas sobre ellas, derecho con derecho, y "
     "coser por: {1}. Volverlas, remeter el último borde y coserlo a mano sobre su costura."},
    {"step.layers_first",
     "Unir las capas de {0}, derecho con derecho, por: {1}. Volver y planchar; desde aquí son una, y lo que "
     "se ve al llevarla queda fuera."},
    {"step.linings",
     "Forros: {0}. Cortar lo que cubren las vistas y la tira doblada, menos 2 cm, y unir las piezas como las "
     "de la tela. Colocar el forro, revés con revés, remeter sus bordes 1 cm y coserlos a mano a los bordes "
     "interiores de vistas, tira y dobladillos."},
    {"step.loop",
     "Doblar la tira en tres a lo largo y pespuntear sus dos bordes; cortarla en cinco trabillas iguales y "
     "coserlas sobre la pretina en el centro de la espalda, en los costados y en el medio de cada delantero: "
     "{0}."},
    {"step.over", "Sobre la costura ({0}): {1}. Coser derecho con derecho, volver hacia dentro y planchar."},
    {"step.over_joined",
     "Sobre la costura ({0}): {1}. Unirlas como las piezas de allí, coser derecho con derecho, volver hacia "
     "dentro y planchar. Los extremos en una abertura se remeten."},
    {"step.over_rib",
     "Sobre la costura ({0}): {1}, {2} de largo. Cerrar en anillo, doblar por su línea, revés con revés, y "
     "coser sus dos bordes derecho con derecho, estirando por igual de piquete a piquete."},
    {"step.part", "Preparar y coser: {0}."},
    {"step.patch",
     "Hacer el dobladillo del borde superior ({1}), doblar los demás bordes y pespuntear sobre su línea en: {0}."},
    {"step.placket", "Doblar {1} hacia el revés y pespuntear ({2}): {0}."},
    {"step.placket_line",
     "Doblar {1} hacia el revés por la línea «{3}» y planchar ({2}): {0}. Donde acaba en un borde que "
     "luego lleva vista o dobladillo, doblarla hacia el derecho sobre él, coser de través con el borde y "
     "volverla; después pespuntearla."},
    {"step.pleats", "Formar los pliegues por sus líneas y sujetarlos dentro del margen de costura: {0}."},
    {"step.pouch",
     "Hacer el dobladillo de las aberturas ({1}), doblar los demás bordes y pespuntearlos sobre su línea en: "
     "{0}. Un borde que queda sobre una costura no se dobla y se coge en ella."},
    {"step.sew", "Coser:"},
    {"step.sew_in_one", "Coser, de una sola vez:"},
    {"step.sleeve_placket",
     "Cortar la abertura de la manga por su línea y coser a sus dos bordes de una vez: {0}. Doblar sobre el "
     "borde cortado y pespuntear, coser de través el doblez en lo alto de la abertura y planchar la mitad "
     "delantera hacia dentro."},
    {"step.stand",
     "Segunda capa de {0}: ponerla sobre la primera, derecho con derecho, con lo que va cosido al borde "
     "superior entre ambas, y coser por el borde superior y en los dos extremos por las líneas «{2}», que "
     "coinciden con los dobleces de los delanteros. Volver; la costura del escote sigue hasta esos dobleces; "
     "remeter el borde inferior y coserlo a mano sobre ella."},
    {"step.tie_make", "Doblar a lo largo, coser el borde largo y un extremo, volver y planchar: {0}."},
    {"step.ties",
     "Coser el lazo corto al extremo del delantero izquierdo, que queda encima, y el largo al del derecho, "
     "derecho con derecho: la vista se cose sobre ellos. Al vestirse, sacar el lazo largo por la ranura, "
     "llevarlo alrededor de la cintura y atarlo al corto:"},
    {"step.turn", "Rematar el borde ({0}: {1}, {2} en total): doblar hacia el revés y pespuntear."},
    {"step.turn_elastic",
     "Rematar el borde ({0}: {1}, {2} en total): doblar hacia el revés y pespuntear dejando una abertura; "
     "pasar el elástico, coser sus extremos borde con borde y cerrar."},
    {"step.underlap",
     "El cruce inferior ({0}) sobresale {1} de la línea de costura, hasta su marca: ahí y por su borde "
     "inferior se cosen sus capas, y no en la línea misma."},
    {"step.welt",
     "Bolsillos de vivo, de {0}: doblar cada vivo, derecho con derecho, coser sus extremos y volverlo. Coserlo "
     "a la línea inferior de su sitio con una capa de la bolsa encima, y la otra capa a la superior; cortar "
     "entre ambas hasta las esquinas, meter la bolsa, pespuntear los extremos del vivo hacia arriba y unir las "
     "capas de la bolsa."},
    {"unit.degree", "°"},
};

const mus__language_list mus__sentences_es = {sentences_es, (int32_t)(sizeof sentences_es / sizeof sentences_es[0])};

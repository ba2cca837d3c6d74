/*
 * sentences_pt.c: what paper and instructions say, in Portuguese.
 */
#include "language/language.h"

static const mus__language_row sentences_pt[] = {
    {"buttons.many", "{0} botões"},
    {"buttons.one", "{0} botão"},
    {"cloth.wide", "{0} de largura: {1}"},
    {"count.main", "{0} ×"},
    {"count.other", "{0} × {1}"},
    {"cut.fold", "Cortar {0} na dobra"},
    {"cut.mirrored", "Cortar {0} em par espelhado"},
    {"cut.plain", "Cortar {0}"},
    {"depth", "{0} mm"},
    {"ease.ease", "embeber: {0}, {1}"},
    {"ease.gather", "franzir: {0}, {1}, com duas fileiras de pontos longos na margem, puxadas por igual"},
    {"ease.pleats", "encurtado pelas pregas: {0}, {1}"},
    {"ease.rib", "esticar: {0}, de {1} para {2}"},
    {"fabric.cotton", "tecido de algodão"},
    {"fabric.denim", "denim"},
    {"fabric.jersey", "malha jersey elástica"},
    {"fabric.pc_twill", "sarja de algodão e poliéster"},
    {"fabric.polyester", "poliéster leve e fluido"},
    {"fabric.satin", "cetim"},
    {"fabric.shirting", "tecido de camisaria"},
    {"fabric.tropical", "lã fria para ternos"},
    {"fabric.wool", "tecido de lã"},
    {"facts.cover.many", "{0} páginas depois desta, {1} x {2}, escala 1:1"},
    {"facts.cover.one", "{0} página depois desta, {1} x {2}, escala 1:1"},
    {"facts.many", "{0} páginas, {1} x {2}, escala 1:1"},
    {"facts.one", "{0} página, {1} x {2}, escala 1:1"},
    {"facts.person", "Para {0}.  {1}"},
    {"head.asked", "pedido"},
    {"head.cloth", "Tecido"},
    {"head.drafted", "Traçado segundo estas medidas"},
    {"head.error", "erro"},
    {"head.made", "obtido"},
    {"head.measures", "medida"},
    {"head.notions", "Aviamentos"},
    {"head.pieces", "Partes do molde"},
    {"head.sewing", "Montagem: costurar nas linhas de traços curtos, direito com direito, salvo outra indicação"},
    {"layout.fold", "dobra do tecido"},
    {"layout.layers", "duas camadas"},
    {"layout.length", "Tecido necessário: {0} m com {1} mm de largura"},
    {"layout.nap", "tecido com pé: todas as partes no mesmo sentido"},
    {"layout.on_fold", "na dobra"},
    {"layout.selvedge", "ourela"},
    {"layout.selvedges", "ourelas"},
    {"layout.spare", "duas camadas, uma sobra"},
    {"layout.title", "Plano de corte"},
    {"layout.turned", "virada"},
    {"length", "{0},{1} cm"},
    {"line.alike", "igual à esquerda e à direita"},
    {"line.at", "{0} com {1} ({2})"},
    {"line.dart.many", "{0}: {1} pences de {2}"},
    {"line.dart.one", "{0}: {1} pence de {2}"},
    {"line.edges", "{0} ({1}) com {2} ({3})"},
    {"line.folded", "dobrar antes na linha, avesso com avesso, e costurar as duas bordas"},
    {"line.onto", "{0} sobre {1}"},
    {"line.panels", "{0} com {1}"},
    {"line.pleat.many", "{0}: {1} pregas de {2}"},
    {"line.pleat.one", "{0}: {1} prega de {2}"},
    {"line.same_panel", "{0}: {1} com {2}"},
    {"line.slit", "de uma borda da abertura à outra"},
    {"line.slot",
     "na esquerda deixar aberta a passagem, da cintura até os três piques: por ela sai a amarração longa"},
    {"line.zip", "pregar o zíper: {0}"},
    {"list.colon", "{0}: {1}"},
    {"list.comma", ", "},
    {"list.semicolon", "; "},
    {"mark.biceps", "linha do braço"},
    {"mark.button", "botão"},
    {"mark.buttonhole", "casa de botão"},
    {"mark.flap", "aba"},
    {"mark.fold", "dobra"},
    {"mark.grain", "fio"},
    {"mark.interfacing", "entretela"},
    {"mark.kangaroo pocket", "bolso canguru"},
    {"mark.placket", "carcela"},
    {"mark.pleat", "prega"},
    {"mark.pocket", "bolso"},
    {"mark.pocket opening", "abertura do bolso"},
    {"mark.slit", "fenda"},
    {"mark.slot", "passagem"},
    {"mark.stand end", "fim do pé de gola"},
    {"mark.tie", "amarração"},
    {"mark.underlap", "transpasse inferior"},
    {"mark.welt", "vivo"},
    {"mark.zip", "zíper"},
    {"material.elastic", "elástico"},
    {"material.interfacing", "entretela"},
    {"material.lining", "forro"},
    {"material.main", "tecido principal"},
    {"material.rib", "ribana"},
    {"measure.derived", "deduzida"},
    {"measure.volume", "volume {0} l, {1} ms"},
    {"metres", "{0},{1} m"},
    {"notches.many", "{0} piques"},
    {"notches.one", "{0} pique"},
    {"notes.made_for", "Pensado para: {0}"},
    {"notion.elastic", "elástico, {0} × {1}, {2} de largura"},
    {"notion.fly", "zíper para a braguilha, {0}"},
    {"notion.zip", "zíper para uma abertura de {0}"},
    {"paper.allowance", "Margem de costura incluída: {0} mm"},
    {"paper.allowance_at", "Margem de costura incluída: {0}"},
    {"paper.cut", "Linha contínua: cortar."},
    {"paper.cut_sizes", "Linha grossa, com os traços do seu tamanho: cortar."},
    {"paper.dart", "dobrar aqui"},
    {"paper.edge", "{0} {1} mm"},
    {"paper.empty", "As casas sem linhas não têm página: {0}."},
    {"paper.fold", "dobra do tecido"},
    {"paper.inner", "quadrado interno: 100 mm"},
    {"paper.measure", "medir: imprimir a 100 %, escala 1:1"},
    {"paper.more", "e mais {0}"},
    {"paper.no_allowance", "Sem margem de costura"},
    {"paper.none_at", "sem margem: {0}"},
    {"paper.other_edges", "outras bordas"},
    {"paper.outer", "quadrado externo: 4 polegadas"},
    {"paper.person", "Para {0}"},
    {"paper.piece", "Parte {0} de {1}"},
    {"paper.scale", "Escala 1:1"},
    {"paper.sizes", "Tamanhos {0}"},
    {"paper.step.1", "Imprimir a 100 %, nunca “ajustar à página”, e medir os dois quadrados antes de cortar."},
    {"paper.step.2", "Recortar as margens esquerda e superior ao longo da moldura."},
    {"paper.step.3",
     "Colocar cada página sobre as vizinhas, moldura sobre moldura, até os losangos ficarem inteiros, e colar."},
    {"paper.step.4",
     "{0} Traços curtos: costurar, ou virar uma bainha. Traços longos: o que a palavra diz, como dobra ou "
     "lugar. Cruz: ponto a marcar. Seta dupla: fio do tecido. Riscos curtos na linha de corte: piques; três "
     "juntos: fim do fecho ou da abertura, no do meio."},
    {"paper.step.5",
     "Cruz numa linha: casa na frente de cima, botão na de baixo. Por cima fica a frente esquerda nos homens, a "
     "direita nas mulheres."},
    {"paper.tile", "{0}  página {1} de {2}  escala 1:1"},
    {"sewing.general",
     "Chulear as bordas cortadas e passar cada costura antes que outra a cruze; costurar malha com ponto "
     "elástico ou zigue-zague. Na bainha que desfia, virar antes a borda cortada."},
    {"step.buttons", "Fazer as casas na parte de cima e pregar os botões na de baixo:"},
    {"step.close", "Fechar:"},
    {"step.close_in_one", "Fechar, de uma só vez:"},
    {"step.darts", "Costurar as pences:"},
    {"step.darts_pleats", "Costurar as pences e formar as pregas:"},
    {"step.elastic", "Esticar o elástico e costurar por dentro ({0})."},
    {"step.faced",
     "Arrematar a borda ({0}: {1}, {2} no total) com: {3}. Costurar direito com direito, virar para dentro e passar "
     "a ferro."},
    {"step.faced_joined",
     "Arrematar a borda ({0}: {1}, {2} no total) com: {3}. Unir como estes, costurar direito com direito, "
     "virar para dentro e passar a ferro. As pontas numa abertura são dobradas para dentro."},
    {"step.faced_rib",
     "Arrematar a borda ({0}: {1}, {2} no total) com: {3}, {4} de comprimento. Fechar em anel, dobrar na "
     "linha, avesso com avesso, e costurar as duas bordas direito com direito, esticando por igual de pique a "
     "pique."},
    {"step.flap",
     "Bolsos com lapela, de {0}: unir duas a duas as camadas de uma lapela em três lados e virar; dobrar cada "
     "vivo. Costurar o vivo à linha inferior do seu lugar e a lapela à superior, cada um com uma camada do "
     "forro; cortar entre eles até os cantos, virar o forro para dentro e unir as camadas."},
    {"step.fly",
     "Braguilha, de {0}; é assim que se coloca o zíper mais abaixo: costurar a vista à borda da abertura da "
     "frente esquerda e virá-la para dentro. Dobrar o pertingal ao comprido, direito com direito, costurar a "
     "ponta de baixo, virá-lo e pô-lo sob a borda da frente direita com uma fita do zíper entre os dois e "
     "pespontar. Costurar a outra fita só à vista e pespontar a frente esquerda pela curva da vista."},
    {"step.fold",
     "Arrematar a borda ({0}: {1}, {2} no total): dobrar na linha “{3}”, direito com direito, fechar as "
     "pontas abertas, um transpasse na sua marca e por baixo, e virar; dobrar a borda cortada e pespontá-la "
     "sobre a costura."},
    {"step.fold_elastic",
     "Arrematar a borda ({0}: {1}, {2} no total): dobrar para dentro na linha “{3}”, virar a borda cortada "
     "e pespontá-la sobre a costura deixando uma abertura; passar o elástico, costurar as pontas borda com "
     "borda e fechar."},
    {"step.front_pocket",
     "Bolsos da frente, de {0}: cortar a frente na linha “{1}” deixando uma margem de costura. Costurar "
     "uma camada do forro a essa borda, direito com direito, cortá-la igual, virar para dentro e pespontar. "
     "Costurar a vista à outra camada, pô-la sob a abertura e unir as camadas pela borda interna."},
    {"step.fuse", "Colar a entretela a ferro em: {0}."},
    {"step.fuse_line", "Colar {1} a ferro no avesso de: {0}, com as linhas “{2}” uma sobre a outra."},
    {"step.hem", "Arrematar a borda ({0}: {1}, {2} no total): virar {3} para o avesso e pespontar."},
    {"step.hem_elastic",
     "Arrematar a borda ({0}: {1}, {2} no total): virar {3} para o avesso e pespontar deixando uma abertura; "
     "passar o elástico, costurar as pontas borda com borda e fechar."},
    {"step.lay_on", "Fazer a bainha de cima, virar as outras bordas, aplicar e pespontar em volta, aberto em cima:"},
    {"step.layers",
     "Segundas camadas: {0}. Unir entre si como as primeiras, pôr sobre elas, direito com direito, e costurar "
     "em: {1}. Virar, dobrar a última borda e costurá-la à mão sobre a sua costura."},
    {"step.layers_first",
     "Unir as camadas de {0}, direito com direito, em: {1}. Virar e passar; daqui em diante são uma só, e o "
     "que se vê ao usar fica por fora."},
    {"step.linings",
     "Forros: {0}. Cortar o que vistas e carcela dobrada cobrem, menos 2 cm, e unir as peças como as do "
     "tecido. Colocar o forro, avesso com avesso, dobrar as bordas 1 cm e costurá-las à mão às bordas "
     "internas de vistas, carcela e bainhas."},
    {"step.loop",
     "Dobrar a tira em três ao comprido e pespontar as duas bordas; cortar em cinco passantes iguais e "
     "costurá-los por cima do cós no centro das costas, nas laterais e no meio de cada frente: {0}."},
    {"step.over", "Sobre a costura ({0}): {1}. Costurar direito com direito, virar para dentro e passar a ferro."},
    {"step.over_joined",
     "Sobre a costura ({0}): {1}. Unir como as peças dali, costurar direito com direito, virar para dentro e "
     "passar a ferro. As pontas numa abertura são dobradas para dentro."},
    {"step.over_rib",
     "Sobre a costura ({0}): {1}, {2} de comprimento. Fechar em anel, dobrar na linha, avesso com avesso, e "
     "costurar as duas bordas direito com direito, esticando por igual de pique a pique."},
    {"step.part", "Preparar e costurar: {0}."},
    {"step.patch", "Fazer a bainha da borda superior ({1}), virar as outras bordas e pespontar na marcação em: {0}."},
    {"step.placket", "Virar {1} para o avesso e pespontar ({2}): {0}."},
    {"step.placket_line",
     "Virar {1} para o avesso pela linha “{3}” e passar ({2}): {0}. Onde termina numa borda que depois "
     "leva vista ou bainha, virar para o direito por cima dela, costurar de través com a borda e desvirar; "
     "depois pespontar."},
    {"step.pleats", "Formar as pregas pelas linhas e prender dentro da margem de costura: {0}."},
    {"step.pouch",
     "Fazer a bainha das aberturas ({1}), virar as outras bordas e pespontá-las na marcação em: {0}. Uma "
     "borda sobre uma costura fica lisa e é presa nela."},
    {"step.sew", "Costurar:"},
    {"step.sew_in_one", "Costurar, de uma só vez:"},
    {"step.sleeve_placket",
     "Cortar a abertura da manga na linha e costurar às duas bordas de uma vez: {0}. Dobrar sobre a borda "
     "cortada e pespontar, costurar através da dobra no alto da abertura e passar a metade da frente para "
     "dentro."},
    {"step.stand",
     "Segunda camada de {0}: pôr sobre a primeira, direito com direito, com o que vai costurado à borda "
     "superior entre as duas, e costurar pela borda superior e nas duas pontas pelas linhas “{2}”, que "
     "encontram as dobras das frentes. Virar; a costura do decote segue até essas dobras; dobrar a borda "
     "inferior e costurá-la à mão sobre ela."},
    {"step.tie_make", "Dobrar ao comprido, costurar a borda longa e uma ponta, virar e passar: {0}."},
    {"step.ties",
     "Costurar a amarração curta à ponta da frente esquerda, que fica por cima, e a longa à da frente "
     "direita, direito com direito: a vista é costurada por cima. Ao vestir, tirar a longa pela passagem, "
     "levá-la em volta da cintura e atá-la à curta:"},
    {"step.turn", "Arrematar a borda ({0}: {1}, {2} no total): virar para o avesso e pespontar."},
    {"step.turn_elastic",
     "Arrematar a borda ({0}: {1}, {2} no total): virar para o avesso e pespontar deixando uma abertura; "
     "passar o elástico, costurar as pontas borda com borda e fechar."},
    {"step.underlap",
     "O transpasse inferior ({0}) ultrapassa a linha de costura em {1}, até a sua marca: ali e na borda "
     "inferior se costuram as suas camadas, e não na própria linha."},
    {"step.welt",
     "Bolsos com vivo, de {0}: dobrar cada vivo, direito com direito, costurar as pontas e virar. Costurá-lo "
     "à linha inferior do seu lugar com uma camada do forro por cima, e a outra camada à superior; cortar "
     "entre elas até os cantos, virar o forro para dentro, pespontar as pontas do vivo para cima e unir as "
     "camadas do forro."},
    {"unit.degree", "°"},
};

const mus__language_list mus__sentences_pt = {sentences_pt, (int32_t)(sizeof sentences_pt / sizeof sentences_pt[0])};

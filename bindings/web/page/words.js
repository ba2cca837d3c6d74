// words.js: the words of the page; the page itself has the English ones.
export const languages = { en: "English", de: "Deutsch", fr: "Français", es: "Español" };
const names = (
    "garment search design fabric colour map plain warp weft pressure gap wearer size pose tape ease take " +
    "paper roll tapeOut share language stature bust waist hip back_waist arm inleg standing sewing " +
    "settling atRest failed linked "
).trim().split(" ");
const told = {
    en:
        "Garment|Search|Design|Fabric|Colour|Fit|colour|strain along the warp|strain along the weft|pressure|" +
        "distance to the body|Wearer|Size|Pose|Tape file|Ease|Take home|Paper|roll|Tape|Link|Language|" +
        "Stature|Bust|Waist|Hip|Back waist|Arm|Inside leg|standing|sewing|settling|at rest|not dressed|" +
        "link copied",
    de:
        "Kleidungsstück|Suche|Entwurf|Stoff|Farbe|Passform|Farbe|Dehnung in Kettrichtung|" +
        "Dehnung in Schussrichtung|Druck|Abstand zum Körper|Person|Größe|Haltung|Maßdatei|Zugabe|Mitnehmen|" +
        "Papier|Rolle|Maße|Link|Sprache|Körperhöhe|Oberweite|Taille|Hüfte|Rückenlänge|Armlänge|Schrittlänge|" +
        "stehend|wird genäht|kommt zur Ruhe|in Ruhe|nicht angezogen|Link kopiert",
    fr:
        "Vêtement|Recherche|Modèle|Tissu|Couleur|Aisance|couleur|allongement en chaîne|allongement en trame|" +
        "pression|distance au corps|Personne|Taille|Pose|Fichier de mesures|Aisance|Emporter|Papier|rouleau|" +
        "Mesures|Lien|Langue|Stature|Poitrine|Tour de taille|Hanches|Dos|Bras|Entrejambe|debout|couture|" +
        "mise au repos|au repos|non habillé|lien copié",
    es:
        "Prenda|Buscar|Diseño|Tela|Color|Ajuste|color|deformación en urdimbre|deformación en trama|presión|" +
        "distancia al cuerpo|Persona|Talla|Pose|Archivo de medidas|Holgura|Llevar|Papel|rollo|Medidas|Enlace|" +
        "Idioma|Estatura|Pecho|Cintura|Cadera|Talle espalda|Brazo|Entrepierna|de pie|cosiendo|asentando|" +
        "en reposo|sin vestir|enlace copiado",
};
const tables = Object.fromEntries(Object.entries(told).map(([language, line]) =>
    [language, Object.fromEntries(line.split("|").map((text, i) => [names[i], text]))]));
export const word = (language, name) => tables[language]?.[name] ?? tables.en[name] ?? name;

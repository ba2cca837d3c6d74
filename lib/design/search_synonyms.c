/*
 * search_synonyms.c: words of shops and patterns, American and British, and the words of the catalogue that they mean.
 *
 * A row is read by design_search.c, as search_text.h says. To teach the search a word, add it to a row. A phrase that
 * has a row is taken before a shorter one: "night dress" before "dress".
 */
#include "design/search_text.h"

const mus__synonym mus__synonyms[] = {
    /* whom it is for */
    {"child|children|kid|boy|girl|toddler|infant|baby|junior|youth|schoolgirl|schoolboy", "child"},
    {"man|men|male|guy|gent|gentleman|gentlemen|masculine|him|his", "men"},
    {"woman|women|lady|ladies|female|feminine|her|misses|miss", "women"},
    {"unisex|gender neutral", "men women"},

    /* words that choose no design: colours, cloths, prints, praise */
    {"black|white|red|blue|navy|green|yellow|pink|purple|grey|gray|beige|brown|cream|ivory|orange|khaki|olive|gold|"
     "silver|burgundy|pastel|neon", ""},
    {"cotton|linen|wool|woollen|woolen|silk|satin|velvet|polyester|viscose|rayon|chiffon|lace|leather|suede|corduroy|"
     "cord|tweed|flannel|fleece|cashmere|merino|lycra|spandex|nylon|organic|crepe|chambray|poplin|gabardine|ponte", ""},
    {"floral|flower|flowers|print|printed|stripe|plain|solid|checked|gingham|polka|dot|embroidered|sequin|animal|"
     "leopard", ""},
    {"new|sexy|cute|casual|smart|simple|basic|easy|classic|elegant|modern|stylish|trendy|comfortable|comfy|lightweight|"
     "light|warm|summer|winter|spring|autumn|fall|holiday|everyday|best|cheap|soft|pretty|nice|sale|fashion", ""},
    {"pattern|sewing|sew|size|style|outfit|clothes|clothing|garment|wear|uniform|costume|set|look|piece", ""},
    {"petite|tall|plus|curvy|curve|maternity|small|large|big|xl|xxl|medium", ""},

    /* tops of knit */
    {"tee|t shirt|tshirt|tee shirt", "t shirt|tee|knit top"},
    {"sweater|jumper|pullover|knitwear|jersey top|knitted top", "knit top|sweatshirt"},
    {"sweat shirt|crewneck sweatshirt|sweat top", "sweatshirt"},
    {"hoody|hooded top|hooded sweatshirt|hooded sweater|hooded jumper|hooded jacket", "hoodie"},
    {"zip up|zip through|full zip|zipped|zipper|zip front|zippered", "zip|front closure"},
    {"roll neck|rollneck|polo neck|high neck|mock neck|funnel neck|turtle neck|skivvy", "turtleneck"},
    {"cami|camisole|vest top|singlet|racerback|strappy top|spaghetti strap top|muscle tee|muscle top",
     "tank top|sleeveless top"},
    {"golf shirt|tennis shirt|rugby shirt|polo", "polo shirt"},
    {"nautical|marine|sailor top|sailor shirt|french stripe", "breton|sailor"},
    {"bodysuit|body con|bodycon|tight|fitted|form fitting|figure hugging|close fitting", "close|slim|pencil|fitted"},
    {"belly top|midriff|bralette|crop top|cropped top", "cropped|crop"},
    {"baseball tee|baseball shirt|baseball top", "raglan knit top"},

    /* blouses, shirts */
    {"button down|button up|button front|buttoned|button through|button",
     "shirt collar|front closure"},
    {"dress shirt|formal shirt|business shirt|office shirt|work shirt", "shirt with cuffs|straight shirt long|shirt"},
    {"grandad|granddad|grandpa|grandfather|nehru|mao|band collar|stand up collar|stand collar|collarless|"
     "no collar", "mandarin|stand"},
    {"camp shirt|camp collar shirt|hawaiian|aloha shirt|resort shirt|bowling shirt", "wide shirt short sleeve"},
    {"poet shirt|pirate shirt|renaissance blouse|medieval|boho blouse|boho top|folk blouse", "peasant|bishop sleeve"},
    {"overshirt|shacket|boyfriend shirt|oversized shirt", "wide shirt"},
    {"tunic shirt|longline shirt|long line shirt", "long shirt|tunic"},
    {"nurse|doctor|hospital|medical|scrubs|scrub", "scrub top"},
    {"salwar|kameez|kurti|punjabi|indian tunic", "kurta"},
    {"sari top|saree blouse|sari blouse|saree", "choli"},
    {"robe|bathrobe|dressing gown|haori|kimono jacket|kimono", "kimono"},
    {"tube top|bandeau|bandeau top|boob tube", "strapless top"},
    {"corset|bodice top|basque|stays", "corset|bustier|block"},
    {"sloper|toile|fitting shell|moulage|block", "block"},

    /* waistcoats, coats */
    {"vest", "waistcoat|tank|gilet"},
    {"body warmer|bodywarmer|sleeveless jacket|suit vest|waist coat", "waistcoat|gilet"},
    {"shrug|cropped jacket|crop jacket", "bolero"},
    {"jacket|blazer|suit jacket|pea coat|peacoat|reefer|car coat|bomber", "short coat|jacket|coat"},
    {"overcoat|trench|trench coat|trenchcoat|raincoat|rain coat|duster|parka|anorak|topcoat|greatcoat|mac|mackintosh|"
     "duffle coat|duffel coat", "coat"},
    {"cloak|capelet|pelerine|mantle", "cape"},
    {"ruana|serape", "poncho"},

    /* necklines */
    {"crew neck|crewneck|jewel|jewel neck|crew|round neckline|o neck", "round neck|jewel|crew"},
    {"neckline|necked", "neck"},
    {"plunge|plunging|plunging neckline|low cut|deep v neck|deep neck", "deep v"},
    {"bateau|sabrina neck|slash neck|boatneck", "boat neck"},
    {"u neck|scooped", "scoop neck"},
    {"off the shoulder|off shoulder|bardot|bare shoulder|cold shoulder|shoulderless", "strapless"},
    {"halterneck|halter neck|tie neck|backless", "halter"},
    {"heart neckline|heart shaped", "sweetheart"},
    {"teardrop|key hole", "keyhole"},

    /* sleeves, collars, cuffs */
    {"no sleeve|without sleeve|armless|strappy|spaghetti strap|sundress top", "sleeveless"},
    {"full sleeve|long sleeved|longsleeve|ls", "long sleeve"},
    {"short sleeved|shortsleeve|half sleeved|ss", "short sleeve"},
    {"3 4|3 quarter|threequarter|bracelet sleeve", "three quarter"},
    {"half sleeve|elbow length|to the elbow", "elbow sleeve"},
    {"leg of mutton|mutton sleeve|gibson girl|leg o mutton", "gigot"},
    {"batwing|bat wing|grown on sleeve|magyar|kimono sleeve|cocoon", "dolman"},
    {"balloon sleeve|lantern sleeve|blouson sleeve|poet sleeve|full cuffed sleeve", "bishop sleeve|puff sleeve"},
    {"bubble sleeve|puffed sleeve|puffy sleeve|pouf", "puff sleeve"},
    {"flutter sleeve|flared sleeve|trumpet sleeve|angel sleeve|fluted sleeve|butterfly sleeve",
     "bell sleeve|cap sleeve"},
    {"club collar|rounded collar|eton collar|baby collar|bertha|chelsea collar", "peter pan collar"},
    {"lapel|tuxedo|notch collar|notched collar|revers", "shawl collar"},
    {"hooded|with hood|hood", "hood|hooded|hoodie"},

    /* trousers */
    {"pants|pant|slacks|trouser|bottoms|bottom", "trousers"},
    {"sweatpants|sweat pants|track pants|trackpants|tracksuit bottoms|tracksuit pants|tracksuit|jogging bottoms|"
     "jogging pants|jogging|trackies|sweats|jogger pants|jog pants|gym pants", "joggers"},
    {"khakis|khaki pants|chino pants|chino trousers|chino|dockers", "chinos"},
    {"denim|denims|jean|jeans", "jeans|denim"},
    {"skinny|super skinny|drainpipe|stovepipe|cigarette", "slim tapered|tapered|slim"},
    {"slim fit|slimfit|slim leg", "slim"},
    {"peg leg|carrot|narrow leg|tapered leg", "tapered"},
    {"baggy|oversized|oversize|relaxed|relaxed fit|loose fit|slouchy|boyfriend|roomy|loose fitting", "loose|wide"},
    {"flares|flared leg|kick flare|70s pants", "flare|flared|bell bottoms"},
    {"bell bottom|bellbottom|hippie pants", "bell bottoms"},
    {"wide leg|wide legged|wide leg pants", "wide trousers|wide leg|wide"},
    {"straight leg|straight cut|regular fit", "straight"},
    {"high waisted|high waist|high rise|highwaisted|high waister", "high waist|high rise"},
    {"low rise|low waisted|low waist|hipster|hip hugger", "low waist|low rise|contour"},
    {"pedal pushers|clam digger|cropped pants|cropped trousers|crop pants|cropped leggings|7 8", "capri|ankle"},
    {"yoga pants|gym leggings|sports leggings|running tights|tights|treggings|jeggings|stretch pants", "leggings"},
    {"bike|biker|cycle|cyclist|biking|running shorts", "cycling"},
    {"hot pants|short shorts|booty shorts|cut offs", "shorts"},
    {"city shorts|walking shorts|knee length shorts|long shorts|cargo shorts|board shorts", "bermuda"},
    {"gauchos|gaucho|split skirt|divided skirt|skort|trouser skirt", "culottes"},
    {"drop crotch|aladdin|genie|hammer pants|hareem|baggy crotch", "harem"},
    {"drawstring|elasticated|elastic waist|elasticated waist|stretch waist|pull on|elastic waistband|stretchy waist",
     "elastic"},
    {"suit trousers|suit pants|dress pants|dress trousers|formal trousers|office trousers|tailored trousers|work pants",
     "straight trousers"},

    /* nightwear */
    {"pajama|pajamas|pj|pjs|pyjama|pyjamas|pajama set|sleepwear|nightwear|loungewear|lounge|sleep|jammies",
     "pyjama|nightwear"},
    {"nightie|nighty|nightdress|night dress|night gown|chemise", "nightgown"},
    {"sleep shirt|sleepshirt|night shirt", "nightshirt"},

    /* skirts, and skirts of dresses */
    {"skater skirt", "circle skirt mini|full circle skirt"},
    {"circle skirt|circular skirt|round skirt|swirl skirt|twirl skirt", "full circle skirt|circle skirt"},
    {"flared skirt|flare skirt|swing skirt|flippy skirt|flowy skirt", "half circle skirt|circle skirt"},
    {"rara|ra ra|ruffle|ruffled|frill|frilled|frilly|layered|flounce", "tiered|gathered"},
    {"boho skirt|hippie skirt|prairie skirt|peasant skirt|broomstick skirt", "tiered skirt|gypsy skirt"},
    {"tutu|ballet skirt|tulle skirt", "gathered skirt"},
    {"tennis skirt|cheerleader skirt|school skirt|schoolgirl skirt", "pleated skirt mini|pleated skirt"},
    {"pleat|pleats|pleated|accordion|plisse", "pleated|pleats|knife pleated"},
    {"scottish|tartan|highland|plaid skirt", "kilt"},
    {"jean skirt|jeans skirt|denim skirt", "denim skirt"},
    {"fishtail|fish tail|mermaid", "mermaid|trumpet"},
    {"panel skirt|panelled skirt|paneled skirt|gored", "gores"},
    {"wraparound|wrap around|wrapover|wrap over|crossover|tie waist|faux wrap", "wrap"},
    {"beach skirt|pareo|beach wrap|lava lava", "sarong"},
    {"straight cut skirt|office skirt|suit skirt|business skirt", "straight skirt|pencil skirt"},
    {"a shape|aline|trapeze skirt", "a line"},
    {"oktoberfest|drindl|trachten|bavarian", "dirndl"},

    /* lengths */
    {"mini|above knee|above the knee|thigh length|micro", "mini"},
    {"short dress|minidress", "mini dress"},
    {"short skirt|miniskirt", "mini skirt"},
    {"knee length|kneelength|on the knee", "knee|to the knee"},
    {"below knee|below the knee|mid calf|calf length|tea length|mid length|midi length", "midi"},
    {"long dress|floor length dress|full length dress|maxidress", "maxi dress|gown"},
    {"long skirt|floor length skirt|full length skirt|maxiskirt", "maxi skirt"},
    {"floor length|ankle length|full length|maxi", "maxi|ankle"},
    {"asymmetric|asymmetrical|dip hem|dipped hem|mullet|hi lo|hi low|high low", "high low"},
    {"hip length", "to the hip"},
    {"tunic length|longline", "tunic"},

    /* dresses */
    {"evening|prom|formal|gala|black tie|wedding|bridal|bride|bridesmaid|debutante|red carpet|evening dress|"
     "prom dress|formal dress|wedding dress|bridal gown|bridesmaid dress|wedding gown|evening gown", "gown"},
    {"princess gown|cinderella|debutante gown|quinceanera", "ball gown"},
    {"little black dress|lbd|cocktail dress|cocktail", "little black dress|sheath dress"},
    {"cheongsam|chinese dress|mandarin dress|asian dress", "qipao"},
    {"shirtdress|shirtwaister|shirt waister|shirtwaist|button down dress|shirt waist dress", "shirt dress"},
    {"sundress|sun dress|beach dress", "sleeveless dress|halter dress"},
    {"smock|smock dress|trapeze|trapeze dress|muumuu|kaftan|caftan|kaftan dress|oversized dress|loose dress|sack dress",
     "tent dress|loose"},
    {"office dress|work dress|business dress|bodycon dress|tight dress|fitted dress", "sheath dress|pencil dress"},
    {"princess line|princess seam|princess cut", "princess seams|princess"},
    {"babydoll|baby doll", "baby doll"},
    {"empire waist|empire line|high waist dress", "empire"},
    {"jane austen|georgian|bridgerton", "regency"},
    {"jumper dress|pinny|overall dress|dungaree dress|pinafore dress|bib dress", "pinafore"},
    {"sweater dress|knitted dress|jersey dress", "knit dress"},
    {"tee dress|t shirt dress|tshirt dress", "t shirt dress"},
    {"50s|1950s|fifties|rockabilly|swing dance", "swing|poodle|full circle"},
    {"40s|1940s|forties|wartime|vintage", "tea dress"},
    {"60s|1960s|sixties|mod|mod dress", "shift"},
    {"skater|flippy|flowy|flare dress|flared dress|swishy|party dress", "skater|swing|fit and flare"},
    {"flower girl|communion|christening|confirmation|school dress", "child dress"},
    {"polo dress", "collar dress"},

    /* jumpsuits */
    {"dungaree|bib overall|bib overalls|bib|bib and brace|bibs", "salopette"},
    {"overalls", "salopette|overall"},
    {"coverall|boilersuit|workwear|work suit|flight suit|flightsuit|mechanic|jump suit overall", "boiler suit|overall"},
    {"romper|rompers|playsuit|play suit|short jumpsuit|shorts jumpsuit", "romper|playsuit"},
    {"catsuit|cat suit|jump suit|pantsuit one", "jumpsuit"},
    {"all in one|one piece|kigurumi|babygro|babygrow|sleepsuit|union suit|fleece suit", "onesie"},
    {"apron", "apron|tabard"},
};

const int32_t mus__synonym_count = (int32_t)(sizeof mus__synonyms / sizeof mus__synonyms[0]);

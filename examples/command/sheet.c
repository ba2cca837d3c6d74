/*
 * sheet.c: muslin sheet: many designs on many bodies as tiles of one picture.
 *
 * A tile shows one design on one tape, at the spacing given, dressed by the same calls as muslin dress. Workers are
 * processes: each dresses every Nth tile and draws it into shared memory, so that a crash spoils one tile only. A tile
 * whose garment did not come to rest, or could not be drafted, has a red bar at its lower edge, and its reason is in
 * the list on standard output.
 */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "commands.h"
#include "picture.h"

#define ITEM_BYTES 256
#define ITEMS_MOST 4096
#define BAR 4 /* [pixels] height of the red bar */

typedef struct items {
    int32_t count;
    char (*at)[ITEM_BYTES];
} items;

/* the result of a tile */
typedef struct tile {
    char reason[200]; /* "settled", or why not */
    int32_t settled, drawn, nodes;
    double seconds;
} tile;

typedef struct sheet {
    const char *designs, *tapes, *png, *pixels, *fabric_name;
    double spacing_mm, columns, jobs;
    items design, tape;
    mus_fabric fabric;
    int32_t tiles, wide, high; /* number of tiles; width and height of one, in pixels */
    tile *tile;                /* (tiles), shared */
    unsigned char *rgba;       /* (tiles x high x wide x 4), shared */
} sheet;


/* ---- lists ---- */

static int item_add(items *list, const char *text, size_t bytes)
{
    if (bytes == 0) return EXIT_DONE;
    if (bytes >= ITEM_BYTES)
        return complain(EXIT_INPUT, "sheet", "%.40s...: %zu bytes, at most %d", text, bytes, ITEM_BYTES - 1);
    if (list->count == ITEMS_MOST) return complain(EXIT_INPUT, "sheet", "more than %d in a list", ITEMS_MOST);
    char(*more)[ITEM_BYTES] = realloc(list->at, ((size_t)list->count + 1) * sizeof *more);
    if (more == NULL) return complain(EXIT_FAILED, "sheet", "no memory for a list");
    list->at = more;
    memcpy(list->at[list->count], text, bytes);
    list->at[list->count++][bytes] = '\0';
    return EXIT_DONE;
}


/* Splits a list, "a,b,c". */
static int items_split(items *list, const char *text)
{
    int code = EXIT_DONE;
    for (const char *at = text; code == EXIT_DONE && *at != '\0';) {
        const size_t bytes = strcspn(at, ",");
        code = item_add(list, at, bytes);
        at += bytes + (at[bytes] == ',');
    }
    return code;
}


/* Reads a tape's name, which is a size, a file, or FILE.csv:ROW, as the options of a source. */
static void tape_source(char *item, source *from)
{
    char *row = strstr(item, ".csv:");
    if (strchr(item, '.') == NULL) {
        from->size = item;
        return;
    }
    from->tape = item;
    if (row == NULL) return;
    row[4] = '\0';
    from->row = row + 5;
}


/* Returns the group of a tape, a bit of MUS_GROUP_*; prints a line and returns 0 when it cannot be read. */
static int32_t group_of(const char *item)
{
    scene s;
    source from = {0};
    char text[ITEM_BYTES];
    memcpy(text, item, sizeof text);
    tape_source(text, &from);
    int32_t sex = MUS_SEX_UNSET;
    if (scene_open(&s, "sheet") == EXIT_DONE && scene_tape(&s, &from) == EXIT_DONE) sex = mus_tape_sex(s.tape);
    scene_close(&s);
    return sex == MUS_SEX_FEMALE ? MUS_GROUP_WOMEN : sex == MUS_SEX_MALE ? MUS_GROUP_MEN
                                                 : sex == MUS_SEX_CHILD ? MUS_GROUP_CHILDREN
                                                                        : 0;
}


/* Lists "all" named designs of the first tape's group, or for "all:N" N of them, spread over the list. */
static int items_all(sheet *sh, const char *text)
{
    const int32_t group = group_of(sh->tape.at[0]);
    double wanted = mus_design_count();
    if (group == 0) return EXIT_INPUT;
    if (text[3] == ':' && (!number_read(text + 4, &wanted) || wanted < 1.0 || wanted > ITEMS_MOST))
        return complain(EXIT_INPUT, "sheet", "--designs %s: expected all:1 to all:%d", text, ITEMS_MOST);
    int32_t fit = 0, seen = 0, code = EXIT_DONE;
    for (int32_t d = 0; d < mus_design_count(); d++) fit += (mus_design_groups(d) & group) != 0;
    const double each = fmin(1.0, wanted / fmax(1.0, fit));
    for (int32_t d = 0; d < mus_design_count() && code == EXIT_DONE; d++) {
        if ((mus_design_groups(d) & group) == 0) continue;
        const bool take = floor((seen + 1) * each + 1e-9) > floor(seen * each + 1e-9);
        seen++;
        if (take) code = item_add(&sh->design, mus_design_name(d), strlen(mus_design_name(d)));
    }
    return code;
}


/* ---- one tile, in a worker ---- */

static mus_status tile_dress(const sheet *sh, scene *s, mus_body **body, mus_cloth **cloth, mus_drape **drape)
{
    mus_cloth_def cut;
    mus_drape_def def;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_drape_def_init(&def, sizeof def);
    cut.fabric = &sh->fabric;
    cut.spacing = 0.001 * sh->spacing_mm;
    mus_status status = mus_cloth_create(s->context, s->pattern, &cut, cloth);
    if (status == MUS_OK) status = mus_drape_create(s->context, *cloth, *body, &def, drape);
    if (status == MUS_OK) status = mus_drape_place(*drape);
    if (status == MUS_OK) status = mus_drape_sew(*drape, NULL, NULL);
    return status == MUS_OK ? mus_drape_settle(*drape, NULL, NULL) : status;
}


static void tile_bar(const sheet *sh, unsigned char *rgba)
{
    static const unsigned char red[4] = {200, 40, 40, 255};
    for (int32_t y = sh->high - BAR; y < sh->high; y++)
        for (int32_t x = 0; x < sh->wide; x++) memcpy(rgba + 4 * ((size_t)y * (size_t)sh->wide + (size_t)x), red, 4);
}


static void tile_make(const sheet *sh, int32_t t, film *f)
{
    tile *out = &sh->tile[t];
    unsigned char *rgba = sh->rgba + (size_t)t * (size_t)sh->wide * (size_t)sh->high * 4;
    const int32_t d = t / sh->tape.count;
    scene s;
    source from = {0};
    char tape[ITEM_BYTES];
    mus_body *body = NULL;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    garment g = {0};
    memcpy(tape, sh->tape.at[t % sh->tape.count], sizeof tape);
    tape_source(tape, &from);
    if (strchr(sh->design.at[d], ' ') != NULL) from.words = sh->design.at[d];
    else from.design = sh->design.at[d];

    const double start = seconds();
    mus_status status = MUS_OK;
    int code = scene_open(&s, "sheet");
    f->s = &s;
    if (code == EXIT_DONE) code = scene_tape(&s, &from);
    if (code == EXIT_DONE) status = mus_body_create(s.context, s.tape, NULL, &body);
    if (code == EXIT_DONE && status == MUS_OK) code = scene_pattern(&s, &from);
    if (code == EXIT_DONE && status == MUS_OK) status = tile_dress(sh, &s, &body, &cloth, &drape);
    out->settled = code == EXIT_DONE && status == MUS_OK;
    snprintf(out->reason, sizeof out->reason, "%.190s", out->settled ? "settled" : mus_context_error(s.context));

    /* draw the tile; a garment that failed is drawn in its last state */
    const look plain = {0};
    if (drape != NULL && garment_make(&s, &plain, body, cloth, drape, &g) == EXIT_DONE) {
        memcpy(g.view[1].colour, palette[d % PALETTE], sizeof palette[0]);
        out->nodes = mus_cloth_node_count(cloth);
        out->drawn = film_tile(f, &g, sh->wide, sh->high, rgba) == EXIT_DONE;
    }
    if (!out->settled) tile_bar(sh, rgba);
    out->seconds = seconds() - start;
    garment_free(&g);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_body_destroy(body);
    scene_close(&s);
}


/* Dresses and draws every Nth tile from `first` on, and ends the process. */
static void worker(const sheet *sh, int32_t first)
{
    film f;
    scene s;
    const look plain = {0};
    int code = scene_open(&s, "sheet");
    if (code == EXIT_DONE) code = film_open(&f, &s, &plain, NULL);
    for (int32_t t = first; t < sh->tiles && code == EXIT_DONE; t += (int32_t)sh->jobs) tile_make(sh, t, &f);
    film_close(&f);
    scene_close(&s);
    _exit(code);
}


/* ---- the sheet ---- */

static void *shared(size_t bytes)
{
    void *block = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return block == MAP_FAILED ? NULL : block;
}


static int run_workers(sheet *sh)
{
    const int32_t jobs = (int32_t)sh->jobs;
    int started = 0, code = EXIT_DONE;
    fflush(NULL);
    for (int32_t j = 0; j < jobs; j++) {
        const pid_t child = fork();
        if (child == 0) worker(sh, j);
        if (child < 0) code = complain(EXIT_FAILED, "sheet", "no process for worker %d", (int)j);
        else started++;
    }
    for (int status; started > 0; started--) {
        if (wait(&status) < 0) break;
        if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_DONE) code = EXIT_FAILED;
    }
    return code;
}


/* Copies the tiles to the picture, row by row; unused space is light grey. */
static int compose(const sheet *sh)
{
    const int32_t columns = sh->columns < sh->tiles ? (int32_t)sh->columns : sh->tiles;
    const int32_t rows = (sh->tiles + columns - 1) / columns, width = columns * sh->wide, height = rows * sh->high;
    const size_t line = (size_t)sh->wide * 4;
    unsigned char *all = malloc((size_t)width * (size_t)height * 4);
    render_error error;
    if (all == NULL)
        return complain(EXIT_FAILED, "sheet", "no memory for a picture of %d x %d", (int)width, (int)height);
    memset(all, 235, (size_t)width * (size_t)height * 4);
    for (int32_t t = 0; t < sh->tiles; t++)
        for (int32_t y = 0; y < sh->high; y++) {
            const size_t to = (size_t)(t / columns * sh->high + y) * (size_t)width + (size_t)(t % columns * sh->wide);
            const size_t from = ((size_t)t * (size_t)sh->high + (size_t)y) * line;
            if (sh->rgba[((size_t)t * (size_t)sh->high) * line + 3] != 0) memcpy(all + 4 * to, sh->rgba + from, line);
        }
    const int result = render_png_write(sh->png, width, height, all, &error);
    free(all);
    return result == 0 ? EXIT_DONE : complain(EXIT_FAILED, "sheet", "%s", error.text);
}


static int tell(const sheet *sh)
{
    const int32_t columns = (int32_t)sh->columns;
    int32_t settled = 0;
    for (int32_t t = 0; t < sh->tiles; t++) {
        const tile *one = &sh->tile[t];
        settled += one->settled;
        if (is_stdout(sh->png)) continue;
        print_line("row %d column %d: %s on %s: %s, %d nodes, %.1f s", (int)(t / columns) + 1, (int)(t % columns) + 1,
                   sh->design.at[t / sh->tape.count], sh->tape.at[t % sh->tape.count],
                   one->reason[0] != '\0' ? one->reason : "not dressed", (int)one->nodes, one->seconds);
    }
    if (!is_stdout(sh->png)) printf("%d of %d settled\n", (int)settled, (int)sh->tiles);
    if (settled == sh->tiles) return output_end("sheet");
    return complain(EXIT_FAILED, "sheet", "%d of %d did not come to rest", (int)(sh->tiles - settled), (int)sh->tiles);
}


static int read_options(sheet *sh, int argc, char **argv)
{
    sh->spacing_mm = 20.0;
    sh->columns = 0.0;
    sh->jobs = 1.0;
    const option options[] = {
        {"--designs", OPTION_TEXT, &sh->designs, 0, 0,
         "LIST  names or words, between commas; all; all:N, N of those for the first tape"},
        {"--tapes", OPTION_TEXT, &sh->tapes, 0, 0, "LIST  sizes, files or FILE.csv:ROW, separated by commas"},
        {"--png", OPTION_OUTPUT, &sh->png, 0, 0, "FILE  write the picture"},
        {"--columns", OPTION_WHOLE, &sh->columns, 1, 256, "N  number of tiles in a row"},
        {"--tile", OPTION_TEXT, &sh->pixels, 0, 0, "WxH  size of a tile in pixels, default 240x300"},
        {"--fabric", OPTION_TEXT, &sh->fabric_name, 0, 0, "NAME  default jersey"},
        {"--spacing", OPTION_NUMBER, &sh->spacing_mm, 1, 100, "MM  spacing of the nodes, default 20"},
        {"--jobs", OPTION_WHOLE, &sh->jobs, 1, 64, "N  number of processes, default 1"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("sheet", "Dress many designs on many bodies and draw them as one picture.", options, argc, argv))
        return EXIT_INPUT;
    if (sh->designs == NULL || sh->tapes == NULL || sh->png == NULL)
        return complain(EXIT_INPUT, "sheet", "%s is not given",
                        sh->designs == NULL ? "--designs" : sh->tapes == NULL ? "--tapes" : "--png");
    render_error error;
    sh->wide = 240, sh->high = 300;
    if (sh->pixels != NULL && render_size_parse(sh->pixels, &sh->wide, &sh->high, &error) != 0)
        return complain(EXIT_INPUT, "sheet", "--tile: %s", error.text);
    mus_fabric_init(&sh->fabric, sizeof sh->fabric);
    if (mus_fabric_find(sh->fabric_name != NULL ? sh->fabric_name : "jersey", &sh->fabric) != MUS_OK)
        return complain(EXIT_INPUT, "sheet", "--fabric %s: unknown", sh->fabric_name);
    return EXIT_DONE;
}


static int read_lists(sheet *sh)
{
    int code = items_split(&sh->tape, sh->tapes);
    if (code == EXIT_DONE && sh->tape.count == 0) return complain(EXIT_INPUT, "sheet", "--tapes: the list is empty");
    const bool all = strncmp(sh->designs, "all", 3) == 0 && (sh->designs[3] == '\0' || sh->designs[3] == ':');
    if (code == EXIT_DONE) code = all ? items_all(sh, sh->designs) : items_split(&sh->design, sh->designs);
    if (code != EXIT_DONE) return code;
    if (sh->design.count == 0) return complain(EXIT_INPUT, "sheet", "--designs: the list is empty");
    for (int32_t d = 0; d < sh->design.count; d++)
        if (strchr(sh->design.at[d], ' ') == NULL && design_named("sheet", "--designs", sh->design.at[d]) == MUS_NONE)
            return EXIT_INPUT;
    if ((int64_t)sh->design.count * sh->tape.count > ITEMS_MOST)
        return complain(EXIT_INPUT, "sheet", "%lld tiles, at most %d",
                        (long long)sh->design.count * sh->tape.count, ITEMS_MOST);
    sh->tiles = sh->design.count * sh->tape.count;
    if (sh->columns == 0.0) sh->columns = ceil(sqrt(1.6 * sh->tiles * sh->high / sh->wide));
    if (sh->jobs > sh->tiles) sh->jobs = sh->tiles;
    return EXIT_DONE;
}


int command_sheet(int argc, char **argv)
{
    sheet sh = {0};
    int code = read_options(&sh, argc, argv);
    if (code == EXIT_DONE) code = read_lists(&sh);
    const size_t pixels = (size_t)sh.tiles * (size_t)sh.wide * (size_t)sh.high * 4;
    if (code == EXIT_DONE) {
        sh.tile = shared((size_t)sh.tiles * sizeof *sh.tile);
        sh.rgba = shared(pixels);
        if (sh.tile == NULL || sh.rgba == NULL)
            code = complain(EXIT_FAILED, "sheet", "no memory for %d tiles", (int)sh.tiles);
    }
    if (code == EXIT_DONE) code = run_workers(&sh);
    if (sh.tile != NULL && sh.rgba != NULL) {
        const int drawn = compose(&sh), told = tell(&sh);
        if (code == EXIT_DONE) code = drawn != EXIT_DONE ? drawn : told;
    }
    if (sh.tile != NULL) munmap(sh.tile, (size_t)sh.tiles * sizeof *sh.tile);
    if (sh.rgba != NULL) munmap(sh.rgba, pixels);
    free(sh.design.at);
    free(sh.tape.at);
    return code;
}

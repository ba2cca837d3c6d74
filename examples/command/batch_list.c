/*
 * batch_list.c: reads the list of a batch: one garment on each line, split into words as a shell does.
 *
 *     # name            what                                    on whom
 *     --name summer     --words "dress neck=v skirt=half"       --size W40
 *                       --pattern specs/d11_007.json            --tape bodies/mean_all.yaml --spacing 15
 *
 * A line has the options given beside --batch, overruled by its own. Its key is an FNV-1a hash of 64 bits over all
 * inputs of the result: the options, the bytes of the files that they name, and the program. A garment is dressed again
 * when, and only when, its key has changed.
 */
#define _POSIX_C_SOURCE 200809L /* stat, readlink */
#include "batch.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define FNV_START UINT64_C(0xcbf29ce484222325)
#define FNV_PRIME UINT64_C(0x100000001b3)

/* options of the batch itself, which no line may have */
static const char *const of_batch[] = {"--batch", "-o",    "--jobs", "--limit", "--png", "--glb",
                                       "--obj",   "--part", "--quiet", "--help",  "-h"};
/* options of a single garment, which a batch refuses */
static const char *const of_one[] = {"--report", "--json", "--frames"};
/* groups of options that exclude one another: an option of a line replaces all of its group */
static const char *const garments[] = {"--design", "--words", "--pattern"};
static const char *const bodies[] = {"--tape", "--row", "--size", "--mesh", "--up", "--front", "--unit"};


static bool is_among(const char *word, const char *const *list, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(word, list[i]) == 0) return true;
    return false;
}

#define AMONG(word, list) is_among((word), (list), sizeof(list) / sizeof *(list))


/* ---- hashes ---- */

static uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    for (size_t i = 0; i < count; i++) hash = (hash ^ byte[i]) * FNV_PRIME;
    return hash;
}


/* Hashes a text with its closing 0, so that "ab" "c" differs from "a" "bc". */
static uint64_t hash_text(uint64_t hash, const char *text)
{
    return text == NULL ? hash_bytes(hash, "\xff", 1) : hash_bytes(hash, text, strlen(text) + 1);
}


/* Hashes the bytes of a file; a path that is no file adds nothing. */
static uint64_t hash_file(uint64_t hash, const char *path)
{
    unsigned char block[1 << 14];
    struct stat there;
    FILE *file = stat(path, &there) == 0 && S_ISREG(there.st_mode) ? fopen(path, "rb") : NULL;
    if (file == NULL) return hash;
    for (size_t got; (got = fread(block, 1, sizeof block, file)) > 0;) hash = hash_bytes(hash, block, got);
    fclose(file);
    return hash_bytes(hash, "file", 5);
}


/* Hashes every option but the number of threads, which changes no result; of a text that names a file, its bytes too.
 */
static uint64_t hash_options(const batch *b, dress *d)
{
    option table[DRESS_OPTIONS];
    const int32_t count = dress_options(d, table);
    uint64_t hash = b->program;
    for (const option *o = table; o < table + count; o++) {
        char number[40];
        hash = hash_text(hash, o->name);
        if (o->kind == OPTION_FLAG) {
            hash = hash_text(hash, *(const bool *)o->value ? "yes" : "no");
        } else if (o->kind == OPTION_LIST) {
            const texts *list = o->value;
            for (int32_t i = 0; i < list->count; i++) hash = hash_file(hash_text(hash, list->at[i]), list->at[i]);
        } else if (o->kind == OPTION_TEXT) {
            const char *text = *(const char *const *)o->value;
            hash = hash_text(hash, text);
            if (text != NULL) hash = hash_file(hash, text);
        } else if (strcmp(o->name, "--threads") != 0) {
            snprintf(number, sizeof number, "%.17g", *(const double *)o->value);
            hash = hash_text(hash, number);
        }
    }
    return hash;
}


/* Hashes the version and, where the system tells its path, the bytes of the program: another build may give other
 * numbers. */
static uint64_t hash_program(void)
{
    char version[40];
    snprintf(version, sizeof version, "muslin %d.%d.%d", MUS_VERSION_MAJOR, MUS_VERSION_MINOR, MUS_VERSION_PATCH);
    return hash_file(hash_text(FNV_START, version), "/proc/self/exe");
}


/* ---- options of a line ---- */

int batch_options(const batch *b, const batch_line *g, dress *d, const char **name)
{
    *d = b->all;
    *name = NULL;
    bool what = false, whom = false;
    for (int32_t i = 0; i < g->count; i++) {
        if (AMONG(g->word[i], of_batch))
            return complain(EXIT_INPUT, "dress", "%s stands beside --batch, for all lines", g->word[i]);
        if (AMONG(g->word[i], of_one)) return complain(EXIT_INPUT, "dress", "%s: not in a batch", g->word[i]);
        what = what || AMONG(g->word[i], garments);
        whom = whom || AMONG(g->word[i], bodies);
        if (strcmp(g->word[i], "--view") == 0) d->look.views.count = 0;
        if (strcmp(g->word[i], "--over") == 0) d->over.count = 0;
        if (strcmp(g->word[i], "--colour") == 0) d->look.colours.count = 0;
    }
    if (what) d->from.design = d->from.words = d->from.pattern = NULL;
    if (whom) {
        d->from.tape = d->from.row = d->from.size = NULL;
        memset(&d->mesh, 0, sizeof d->mesh);
    }

    option options[DRESS_OPTIONS + 2];
    const int32_t count = dress_options(d, options);
    options[count] = (option){"--name", OPTION_TEXT, name, 0, 0, "NAME  of the garment, and of its files"};
    options[count + 1] = (option){NULL, OPTION_FLAG, NULL, 0, 0, NULL};
    if (!args_read("dress", "", options, g->count, g->word)) return EXIT_INPUT;
    return dress_check("dress", d);
}


/* ---- names ---- */

/* Appends a text to a name, with a '-' between two texts. Characters that are not portable in file names become '_'. */
static void name_append(char *name, const char *text, size_t length)
{
    size_t at = strlen(name);
    if (at > 0 && at < BATCH_NAME) name[at++] = '-';
    for (size_t i = 0; i < length && at < BATCH_NAME; i++) {
        const char c = text[i];
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                           c == '-' || (c == '.' && at > 0);
        name[at++] = plain ? c : '_';
    }
    name[at] = '\0';
}


/* Appends the last part of a path without its extensions. */
static void name_append_path(char *name, const char *path)
{
    static const char *const endings[] = {".json", ".tape", ".yaml", ".yml", ".vit", ".csv", ".txt", ".obj",
                                          "_specification"};
    const char *slash = strrchr(path, '/'), *from = slash != NULL ? slash + 1 : path;
    size_t length = strlen(from);
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        const size_t ending = strlen(endings[i]);
        if (length > ending && strncmp(from + length - ending, endings[i], ending) == 0) length -= ending;
    }
    name_append(name, from, length);
}


/* Returns the line before `g` that has the same name, or NULL. */
static const batch_line *name_taken(const batch *b, const batch_line *g)
{
    for (const batch_line *other = b->line; other < g; other++)
        if (strcmp(other->name, g->name) == 0) return other;
    return NULL;
}


/* Takes the name given by --name. Returns an exit code. */
static int name_take(const batch *b, batch_line *g, const char *asked)
{
    name_append(g->name, asked, strlen(asked));
    const bool plain = asked[0] != '\0' && strcmp(g->name, asked) == 0;
    const batch_line *other = name_taken(b, g);
    if (plain && other == NULL) return EXIT_DONE;
    g->name[0] = '\0';
    if (plain) return complain(EXIT_INPUT, "dress", "--name %s: that of line %d", asked, (int)other->number);
    return complain(EXIT_INPUT, "dress", "--name %.40s: expected 1 to %d letters, digits, '_', '-' or '.'", asked,
                    BATCH_NAME);
}


/* Makes a name from garment and body; appends a number when it is taken. */
static void name_make(const batch *b, batch_line *g, const dress *d)
{
    const source *from = &d->from;
    const char *what = from->pattern != NULL ? from->pattern : from->design != NULL ? from->design : from->words;
    const char *whom = d->mesh.file != NULL ? d->mesh.file : from->tape != NULL ? from->tape : from->size;
    name_append_path(g->name, what != NULL ? what : "none");
    for (int32_t i = 0; i < d->over.count; i++) name_append_path(g->name, d->over.at[i]);
    if (whom != NULL) name_append_path(g->name, whom);
    if (from->row != NULL) name_append_path(g->name, from->row);
    if (g->name[0] == '\0') name_append(g->name, "none", 4); /* of a path that ends in a slash */
    const size_t length = strlen(g->name);
    for (int32_t n = 2; name_taken(b, g) != NULL; n++) snprintf(g->name + length, 16, "-%d", (int)n);
}


/* ---- the list ---- */

/* Reads a file, or standard input, into a text that ends with 0. Prints a line and returns NULL when it cannot. */
static char *read_all(const char *path)
{
    FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "rb");
    char *text = NULL;
    size_t length = 0, room = 0;
    bool memory = true;
    while (file != NULL && memory) {
        if (length + 1 >= room) {
            char *more = realloc(text, room = 2 * room + 4096);
            memory = more != NULL;
            if (!memory) break;
            text = more;
        }
        const size_t got = fread(text + length, 1, room - length - 1, file);
        length += got;
        if (got == 0) break;
    }
    const bool read = file != NULL && memory && !ferror(file);
    const bool plain = read && memchr(text, 0, length) == NULL;
    if (!plain) complain(memory ? EXIT_INPUT : EXIT_FAILED, "dress", "--batch %s: %s", path,
                         read ? "no list: a byte of it is 0" : memory ? strerror(errno) : "no memory");
    if (file != NULL && file != stdin) fclose(file);
    if (!plain) {
        free(text);
        return NULL;
    }
    text[length] = '\0';
    return text;
}


/*
 * Copies the next word of a line from *from, without its quotes, to *to, which is never ahead of *from. Returns the
 * word, or NULL at the end of the line. *closed becomes false when a quote is not closed.
 */
static char *take_word(const char **from, char **to, bool *closed)
{
    const char *at = *from + strspn(*from, " \t\r\v\f");
    char *word = *to, *out = word;
    char quote = '\0';
    if (*at == '\0' || *at == '#') return NULL;
    for (; *at != '\0' && (quote != '\0' || strchr(" \t\r\v\f", *at) == NULL); at++) {
        if (quote == '\0' && (*at == '"' || *at == '\'')) {
            quote = *at;
        } else if (*at == quote) {
            quote = '\0';
        } else {
            if (*at == '\\' && quote != '\'' && at[1] != '\0') at++;
            *out++ = *at;
        }
    }
    *closed = quote == '\0';
    *from = at + (*at != '\0');
    *out++ = '\0';
    *to = out;
    return word;
}


/* Splits one line into words; an error becomes the line's fault. */
static void read_line(batch *b, batch_line *g, char *text, char ***words)
{
    complaints said;
    const char *from = text, *name = NULL;
    char *to = text;
    bool closed = true;
    g->word = *words;
    for (char *word; closed && (word = take_word(&from, &to, &closed)) != NULL;) g->word[g->count++] = word;
    *words += g->count;
    if (g->count == 0) return;

    complaints_keep(&said);
    dress *d = malloc(sizeof *d);
    int code = d != NULL ? EXIT_DONE : complain(EXIT_FAILED, "dress", "no memory");
    if (code == EXIT_DONE && !closed) code = complain(EXIT_INPUT, "dress", "a quote is not closed");
    if (code == EXIT_DONE) code = batch_options(b, g, d, &name);
    if (code == EXIT_DONE && name != NULL) code = name_take(b, g, name);
    if (code == EXIT_DONE && name == NULL) name_make(b, g, d);
    if (code == EXIT_DONE) g->key = hash_options(b, d);
    else snprintf(g->fault, sizeof g->fault, "line %d: %s", (int)g->number, said.text);
    free(d);
    complaints_keep(NULL);
}


/* Keeps each N-th garment from the I-th on; names are those of the whole list. Returns an exit code. */
static int keep_part(batch *b)
{
    int first = 0, of = 0, end = 0;
    const bool read = sscanf(b->part, "%d/%d%n", &first, &of, &end) == 2 && b->part[end] == '\0';
    if (!read || first < 1 || of < first)
        return complain(EXIT_INPUT, "dress", "--part %.40s: expected I/N with 1 <= I <= N", b->part);
    int32_t kept = 0;
    for (int64_t i = first - 1; i < b->count; i += of) b->line[kept++] = b->line[i];
    b->count = kept;
    return EXIT_DONE;
}


int batch_read(batch *b)
{
    if (b->program == 0) b->program = hash_program();
    b->text = read_all(b->list);
    if (b->text == NULL) return EXIT_INPUT;
    const size_t length = strlen(b->text);
    size_t lines = 1;
    for (const char *c = b->text; *c != '\0'; c++) lines += *c == '\n';
    b->line = calloc(lines, sizeof *b->line);
    /* a word has at least two bytes, with the blank after it */
    b->words = malloc((length / 2 + 2) * sizeof *b->words);
    if (b->line == NULL || b->words == NULL) return complain(EXIT_FAILED, "dress", "--batch %s: no memory", b->list);

    char **words = b->words;
    int32_t number = 1;
    for (char *at = b->text, *end; at != NULL; at = end, number++) {
        end = strchr(at, '\n');
        if (end != NULL) *end++ = '\0';
        batch_line *g = &b->line[b->count];
        g->number = number;
        read_line(b, g, at, &words);
        b->count += g->count > 0;
    }
    if (b->count == 0) return complain(EXIT_INPUT, "dress", "--batch %s: no garment is in the list", b->list);
    return b->part != NULL ? keep_part(b) : EXIT_DONE;
}


void batch_free(batch *b)
{
    free(b->line);
    free(b->words);
    free(b->text);
}

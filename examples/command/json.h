/* json.h: a JSON text that grows member by member, and is then written to a file. */
#ifndef MUSLIN_JSON_H
#define MUSLIN_JSON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The text. `failed` becomes true when there is no memory, and stays true. */
typedef struct json {
    char *text;
    size_t length, capacity;
    bool comma; /* whether the next member needs a comma before it */
    bool failed;
} json;

void json_open(json *j, const char *key, char bracket); /* '{' or '['; key NULL in a list or at the top */
void json_close(json *j, char bracket);
void json_text(json *j, const char *key, const char *value);
void json_int(json *j, const char *key, int64_t value);
void json_bool(json *j, const char *key, bool value);
void json_null(json *j, const char *key);
/* nine significant digits; null when not finite */
void json_number(json *j, const char *key, double value);
/* the member "warnings": the doubts that the command had up to now (args.h) */
void json_warnings(json *j);
void json_free(json *j);

/* Writes the text and a line end to `path`, completely or not at all; "-" is standard output. Complains for `command`.
 */
bool json_write(const json *j, const char *command, const char *path);

#endif

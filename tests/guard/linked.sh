#!/bin/sh
# linked.sh LIBFOLDER: a program carries only the modules that it calls. One that makes a body has nothing of patterns
# and cloth in it, one that edits a pattern nothing of bodies; neither has a drape.
set -eu
lib=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
CC=${CC:-cc}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

carries() # NAME CALL FORBIDDEN
{
    cat >"$scratch/$1.c" <<END
#include <muslin/muslin.h>
int main(void)
{
    mus_context *context = NULL;
    mus_status status = mus_context_create(NULL, &context);
    if (status == MUS_OK) { $2; }
    mus_context_destroy(context);
    return status;
}
END
    $CC -Iinclude "$scratch/$1.c" "$lib/libmuslin.a" -lm -pthread -o "$scratch/$1"
    found=$(nm "$scratch/$1" | grep -oE " (mus_+($3)_[a-z_]*)$" | sort -u | head -n 5)
    if [ -n "$found" ]; then
        echo "a program that only makes a $1 carries" $found
        status=1
    fi
}

carries body 'mus_tape *tape; mus_body *body;
    status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_body_create(context, tape, NULL, &body)' 'pattern|design|cloth|fabric|drape'
carries pattern 'mus_pattern *pattern; int32_t count;
    status = mus_pattern_create(context, "x", &pattern);
    if (status == MUS_OK) status = mus_pattern_check(pattern, &count)' 'tape|body|design|cloth|fabric|drape'
exit $status

#!/bin/sh
# linked.sh LIBFOLDER: a program carries only the modules that it calls.
#
# Small programs are linked with libmuslin.a and --gc-sections. The link map names the members of the archive that went
# in, and each must be of a folder that the program may stand on: one that makes a body has nothing of patterns, cloth
# and drapes in it, one that edits a pattern nothing of bodies. nm must find no symbol of another module either. All
# programs may use libc, libm and threads, and no file: the core opens none.
set -eu
lib=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
CC=${CC:-cc}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

fault() { echo "$*"; status=1; }

# NAME "FOLDERS" FORBIDDEN CALL: FOLDERS of lib/ may be in the program, symbols mus_FORBIDDEN may not
carries()
{
    cat >"$scratch/$1.c" <<END
#include <muslin/muslin.h>
int main(void)
{
    mus_context *context = NULL;
    mus_status status = mus_context_create(NULL, &context);
    if (status == MUS_OK) { $4; }
    mus_context_destroy(context);
    return status;
}
END
    $CC -Iinclude -ffunction-sections "$scratch/$1.c" "$lib/libmuslin.a" -Wl,--gc-sections -Wl,-Map="$scratch/$1.map" \
        -lm -pthread -o "$scratch/$1"

    # what the linker took, by the folder of the file that the member was made of
    members=$(grep -oE 'libmuslin\.a\([a-z0-9_]+\.o\)' "$scratch/$1.map" | sed 's/.*(\(.*\)\.o)/\1/' | sort -u)
    [ -n "$members" ] || fault "$1: the link map names no member of libmuslin.a"
    for member in $members; do
        folder=$(ls lib/*/"$member".c | cut -d/ -f2)
        case " $2 " in
        *" $folder "*) ;;
        *) fault "a program that only makes a $1 links lib/$folder/$member.c" ;;
        esac
    done

    found=$(nm "$scratch/$1" | grep -oE " (mus_+($3)_[a-z_0-9]*)$" | sort -u | head -n 5)
    [ -z "$found" ] || fault "a program that only makes a $1 carries" $found
    files=$(nm -u "$scratch/$1" | grep -oE '\b(fopen|open|fread|fwrite|printf|puts|exit|abort|system|setlocale)(@|$)' || true)
    [ -z "$files" ] || fault "a program that only makes a $1 needs" $files
}

carries context "base" 'tape|body|pattern|design|cloth|fabric|drape|sim|plan|collider|integrate|measure' '(void)0'
carries tape "base tape" 'skeleton|limb|body|pose|pattern|design|cloth|fabric|drape|sim|plan|collider|integrate' '
    mus_tape *tape; status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_complete(tape)'
carries body "base geom tape limb body" 'pose|move|pattern|design|cloth|fabric|drape|sim|plan|collider|integrate' '
    mus_tape *tape; mus_body *body;
    status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_body_create(context, tape, NULL, &body)'
carries pattern "base geom pattern topology" 'tape|body|design|cloth|fabric|drape|sim|plan|collider|integrate' '
    mus_pattern *pattern; int32_t count;
    status = mus_pattern_create(context, "x", &pattern);
    if (status == MUS_OK) status = mus_pattern_check(pattern, &count, NULL)'
carries design "base geom tape limb pattern topology board block half closure style pocket finish design" 'cloth|fabric|drape|sim|plan|collider|integrate' '
    mus_pattern *pattern; status = mus_design_draft(context, 0, NULL, NULL, &pattern)'
carries cloth "base geom pattern topology cloth" 'tape|body|design|drape|sim|plan|collider|integrate' '
    mus_cloth *cloth; status = mus_cloth_create(context, NULL, NULL, &cloth)'
carries drape "base geom tape limb body pose pattern topology cloth contact selfcontact arrange sim drape" 'design|tape_set|tape_complete' '
    mus_drape *drape; status = mus_drape_create(context, NULL, NULL, NULL, &drape)'

# names that a program with one module may not need: an integrator of its own data stands on the ground alone
if grep -q mus_integrate_def include/muslin/muslin.h include/muslin/integrate.h 2>/dev/null; then
    carries integrate "base integrate" 'tape|body|pattern|design|cloth|fabric|drape|sim|plan|collider' '
        double y[2] = {0.0, 1.0}, work[64]; int64_t done; mus_integrate_def def;
        mus_integrate_def_init(&def, sizeof def);
        status = mus_integrate(context, &def, 2, y, 1, work, &done)'
fi
exit $status

#!/bin/sh
# headers.sh: each public header compiles alone, as strict C99 and as C++, without a warning.
set -eu
cd "$(dirname "$0")/../.."
CC=${CC:-cc}
CXX=${CXX:-c++}
status=0
for header in include/muslin/*.h; do
    name=muslin/$(basename "$header")
    for language in "$CC -std=c99 -x c" "$CXX -std=c++98 -Wno-long-long -x c++" "$CXX -std=c++17 -x c++"; do
        printf '#include "%s"\n' "$name" |
            $language -Wall -Wextra -Wpedantic -Werror -Iinclude -fsyntax-only - || {
            echo "$name does not compile alone: $language"
            status=1
        }
    done
done
exit $status

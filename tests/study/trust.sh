#!/bin/sh
# trust.sh NAME OUT: the studies of trust: attack, day, hardening, coverage, check-faults, each with the options of the
# variable of its name (DAY=1728, HARDENING='--runs 3', COVERAGE='--files', FAULTS='--kills 10 batches').
set -eu
out=$2
cd "$(dirname "$0")/../.."
make=${MAKE:-make}
python=${PYTHON:-python3}
case $1 in
attack) exec "$python" tests/guard/attack.py --run "$out" ;;
day) exec "$out/bin/day" ${DAY:-} ;;
hardening)
    $make -s HARDEN_release= OUT="$out/soft" "$out/soft/bin/muslin"
    exec "$python" tests/study/hardening/hardening.py --hard "$out/bin/muslin" --soft "$out/soft/bin/muslin" \
        ${HARDENING:-}
    ;;
coverage)
    $make -s config=coverage OUT="$out/coverage" tests
    exec "$python" tests/study/coverage/coverage.py --out "$out/coverage" ${COVERAGE:-}
    ;;
check-faults)
    exec "$python" tests/study/faults/faults.py --command "$out/bin/muslin" --out "$out/faults" ${FAULTS:-}
    ;;
*)
    echo "trust.sh: $1 is unknown" >&2
    exit 2
    ;;
esac

#!/bin/sh
# Runs the missions that the pages of docs/plans quote anew, and puts what they print into the pages:
#     ./gradlew :crw-cli:installDist && tools/quoted-runs.sh
# Usage: quoted-runs.sh [PAGE...]   (docs/plans/clv.md; all pages unless told)
# A page's answers.json is its JSON block of that format. Lines that differ from run to run or machine to machine are left out, long ones are cut.
set -eu
cd "$(dirname "$0")/.."
bin=$PWD/crw-cli/build/install/crw/bin
if [ ! -x "$bin/crw" ]; then
    echo "quoted-runs: $bin/crw is not there; make it: ./gradlew :crw-cli:installDist" >&2
    exit 2
fi
[ $# -gt 0 ] || set -- docs/plans/*.md
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
cp domain-config/src/main/resources/org/sami/domain/crw/deployments/*.json "$made"
cat > "$made/quoted.sed" << 'END'
/^(  (started|wall time|centre|quay|program|plan hash|run hash) .*)?$/d
s/^(.{150}).+/\1.../
END
for page in "$@"; do
    awk '/^```/ { if (block ~ /"crw-answers"/) printf "%s", block; inside = /^```json/; block = ""; next } inside { block = block $0 "\n" }' \
        "$page" > "$made/answers.json"
    (cd "$made" && PATH=$bin:$PATH LC_ALL=C.UTF-8 awk '
        /^(\$ |```)/ { skips = 0 }
        !skips { print }
        /^\$ crw run / {
            if (system(substr($0, 3) " > out 2> errors") != 0) exit 1
            while (("sed -E -f quoted.sed out" | getline line) > 0) print line
            close("sed -E -f quoted.sed out")
            skips = 1
        }
    ') < "$page" > "$made/page" || {
        cat "$made/errors" >&2
        echo "quoted-runs: a run of $page failed; the page stays as it was" >&2
        exit 1
    }
    cat "$made/page" > "$page"
done

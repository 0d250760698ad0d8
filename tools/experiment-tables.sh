#!/bin/sh
# Runs experiments of docs/experiments.md anew and puts their tables into the page, each with the date and the commit:
#     ./gradlew :crw-cli:installDist && tools/experiment-tables.sh
# Usage: experiment-tables.sh [NAME...]   (library, separation: docs/experiments/NAME.runs; both unless told. SEEDS=1..2 for fewer seeds)
set -eu
cd "$(dirname "$0")/.."
page=docs/experiments.md
crw=crw-cli/build/install/crw/bin/crw
if [ ! -x "$crw" ]; then
    echo "experiment-tables: $crw is not there; make it: ./gradlew :crw-cli:installDist" >&2
    exit 2
fi
[ $# -gt 0 ] || set -- library separation
for name in "$@"; do
    begin="<!-- table of $name.runs -->"
    end="<!-- end of the table of $name.runs -->"
    if [ ! -f "docs/experiments/$name.runs" ] || ! grep -qxF -- "$begin" "$page" || ! grep -qxF -- "$end" "$page"; then
        echo "experiment-tables: there is no docs/experiments/$name.runs, or no '$begin' with its end in $page" >&2
        exit 2
    fi
done
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
for name in "$@"; do
    code=0
    "$crw" experiment --runs "docs/experiments/$name.runs" --seeds "${SEEDS:-1..20}" > "$made/rows" || code=$?
    case $code in
        0 | 3 | 4 | 6) ;; # what failed stands below the table
        *)
            echo "experiment-tables: crw experiment ended with exit code $code; $page keeps the table of $name.runs" >&2
            exit "$code"
            ;;
    esac
    {
        echo
        echo "On $(date -u +%Y-%m-%d), of the commit $(git rev-parse --short=8 HEAD), seeds ${SEEDS:-1..20}:"
        echo
        echo '```'
        cat "$made/rows"
        echo '```'
        echo
    } > "$made/table"
    awk -v begin="<!-- table of $name.runs -->" -v end="<!-- end of the table of $name.runs -->" -v table="$made/table" '
        $0 == end { skips = 0 }
        !skips { print }
        $0 == begin { while ((getline line < table) > 0) print line; skips = 1 }
    ' "$page" > "$made/page"
    cat "$made/page" > "$page"
done

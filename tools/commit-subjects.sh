#!/bin/bash
# Finds commits whose first line is longer than 72 characters: logs and lists cut it there.
# Usage: tools/commit-subjects.sh [FOLDER]   (the project's root unless given)
# Looks at commits written since this check came, as far as the history is there: without git or history it passes.
set -u
longest=72
since=1795676400 # 2026-11-26 07:00 UTC, by the author's clock, which a rebase keeps
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}" || exit 2

export LC_ALL=C.UTF-8 # lengths in characters
long=0
while IFS=$'\t' read -r commit written subject; do
    if [ "$written" -ge "$since" ] && [ "${#subject}" -gt "$longest" ]; then
        echo "commit $commit has a first line of ${#subject} characters, $longest are allowed: $subject" >&2
        long=1
    fi
done < <(git log --no-merges --format='%h%x09%at%x09%s' 2>/dev/null)
exit "$long"

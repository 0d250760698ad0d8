#!/bin/bash
# Runs failed tests of real time a second time, by themselves, after everything else: a machine that stands still for a minute fails a few of them.
# Only tests of these tasks, and at most five of them; what fails in another task, or fails twice, has failed (CONTRIBUTING.md).
# Usage: tools/second-attempt.sh [FOLDER]   (the project's root unless given), after `./gradlew check`
# Exit code 0 if all of them passed now; build/test-summary.txt then counts them as passed and names them. Otherwise it stays as it was.
set -u
real_time=':boat-server-android:server:test :crw-cli:longTest :crw-cli:processTest :crw-mavlink:longTest :crw-mavlink:test :crw-operator-gui:longTest
    :crw-operator-gui:test :crw-operator-gui:windowTest :crw-session:test :crw-sim:longTest :crw-sim:test :dreamm-ide:windowTest
    :journal-postgres:longTest :journal-postgres:test :mavlink:test :pair-postgres:longTest :session-client:test :session-server:test :work-postgres:test'
most=5
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}" || exit 2
summary=build/test-summary.txt
[ -s "$summary" ] || exit 1

first=$(cat "$summary")
failed=$(grep '^FAILED ' <<<"$first")
count=$(grep -c '^FAILED ' <<<"$first")
read -r passed failures < <(sed -nE 's/^([0-9]+) passed, ([0-9]+) failed$/\1 \2/p' <<<"$first" | tail -n 1)
if [ "$count" -eq 0 ] || [ "$count" -gt "$most" ] || [ "$count" -ne "${failures:-0}" ]; then
    exit 1
fi

tests=()
for class in $(cut -d ' ' -f 2 <<<"$failed" | sort -u); do
    mapfile -t found < <(find . -path "*/build/test-results/*/TEST-$class.xml")
    [ "${#found[@]}" -eq 1 ] || exit 1
    module=${found[0]%/build/test-results/*}
    module=${module#.}
    task=$(basename "$(dirname "${found[0]}")")
    task=${module//\//:}:$task
    [[ " $(tr -s ' \n' ' ' <<<"$real_time") " == *" $task "* ]] || exit 1
    tests+=("$task" --tests "$class")
done

echo "A second attempt, by themselves, of $count failed tests of real time: ${tests[*]}"
if ./gradlew --no-daemon --console=plain --max-workers=1 spotlessCheck apk jmhClasses installDist "${tests[@]}" && grep -q ' 0 failed$' "$summary"; then
    {
        sed 's/^FAILED /passed at the second attempt, by itself: /' <<<"$failed"
        grep -v -e '^FAILED ' -e ' failed$' <<<"$first"
        echo "$((passed + failures)) passed, 0 failed"
    } >"$summary"
    exit 0
fi
echo "$first" >"$summary"
exit 1

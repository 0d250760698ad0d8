#!/bin/bash
# Runs failed tests of real time a second time, by themselves, after everything else: a machine that stands still for a minute fails a few of them.
# Only tests of the tasks in real-time-tests.txt, and at most ten of them; what fails in another task, or fails twice, has failed (CONTRIBUTING.md).
# Usage: tools/second-attempt.sh [FOLDER]   (the project's root unless given), after `./gradlew check`
# Exit code 0 if all of them passed now; build/test-summary.txt then counts them as passed and names them. Otherwise it stays as it was.
set -u
most=10
real_time=$(grep -v '^#' "$(dirname "${BASH_SOURCE[0]}")/real-time-tests.txt" | tr '\n' ' ')
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
    [[ " $real_time" == *" $task "* ]] || exit 1
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

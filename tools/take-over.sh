#!/usr/bin/env bash
# Measures how long a standby takes to go on with the session of a base that was killed:
#   tools/take-over.sh 'postgresql://127.0.0.1:5432/boats?user=pilot&schema=kills' [KILLS]
# Needs a PostgreSQL server (apt-get install -y postgresql), the installed command (./gradlew installDist) or CRW=COMMAND, and a schema that has no journal yet, or that of a session.
# READY='the session is held by' kills also while a standby still reads the session for the first time.
# Nothing listens at other addresses than loopback, and no boats are driven. Time counts from kill -9 of the holder to the line of the other base that says where the session is.
set -euo pipefail
journal=$1
kills=${2:-20}
ready=${READY:-standby: ready}
crw=${CRW:-$(dirname "$0")/../crw-cli/build/install/crw/bin/crw}
work=$(mktemp -d)
pids=()
trap 'kill -9 "${pids[@]}" 2>/dev/null || true; rm -rf "$work"' EXIT

# start NUMBER OPTION...: a base, whose output is in the file of its number
start() {
    local number=$1
    shift
    : >"$work/$number"
    "$crw" serve --port 0 --journal "$journal" "$@" >>"$work/$number" 2>&1 &
    pids[number]=$!
}

# await NUMBER TEXT: until a base has said it, 60 s at most
await() {
    for _ in $(seq 6000); do
        grep -q "$2" "$work/$1" && return
        sleep 0.01
    done
    echo "base $1 did not say '$2':" >&2
    cat "$work/$1" >&2
    exit 1
}

start 0
await 0 'the session is at'
for ((n = 1; n <= kills; n++)); do
    start "$n" --standby
    await "$n" "$ready"
    memory=$(awk '/VmRSS/ { print int($2 / 1024) }' "/proc/${pids[n]}/status")
    began=$(date +%s%N)
    kill -9 "${pids[n - 1]}"
    wait "${pids[n - 1]}" 2>/dev/null || true
    await "$n" 'the session is at'
    took=$((($(date +%s%N) - began) / 1000000))
    echo "$took" >>"$work/times"
    echo "take-over $n: $took ms; the standby had $memory MB before"
done
sort -n "$work/times" | awk '{ t[NR] = $1 } END { printf "%d take-overs: median %d ms, p95 %d ms, longest %d ms\n", NR, t[int((NR + 1) / 2)], t[int(NR * 0.95 + 0.999)], t[NR] }'

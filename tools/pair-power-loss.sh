#!/usr/bin/env bash
# Measures how long the second base of a pair takes to go on with the session when the first loses its power, with its database:
#   tools/pair-power-loss.sh [LOSSES]
# Both bases are on this machine, at two addresses of its loopback. Needs PostgreSQL 15 or later (apt-get install -y postgresql) and the installed command (./gradlew installDist) or CRW=COMMAND.
# Time counts from kill -9 of base and database to the line of the other base that says where the session is. Then the first base comes back as the standby, and it is the other's turn.
set -euo pipefail
losses=${1:-10}
crw=${CRW:-$(dirname "$0")/../crw-cli/build/install/crw/bin/crw}
work=$(mktemp -d)
pids=(0 0)
end() {
    kill -9 "${pids[@]}" 2>/dev/null || true
    for base in 0 1; do "$crw" pair stop --pair-folder "$work/$base" >/dev/null 2>&1 || true; done
    rm -rf "$work"
}
trap end EXIT

# start BASE: serves the session there, or stands by
start() {
    "$crw" serve --pair --pair-folder "$work/$1" --port 0 >"$work/out$1" 2>&1 &
    pids[$1]=$!
}

# await BASE TEXT: until it has said it, 60 s at most
await() {
    for _ in $(seq 6000); do
        grep -q "$2" "$work/out$1" && return
        sleep 0.01
    done
    echo "base $1 did not say '$2':" >&2
    cat "$work/out$1" >&2
    exit 1
}

# cut BASE: kill -9 of its base and of its database's processes
cut_power() {
    local server
    server=$(head -n 1 "$work/$1/data/postmaster.pid")
    # shellcheck disable=SC2046 # several numbers are meant
    kill -9 "${pids[$1]}" "$server" $(pgrep -P "$server")
    wait "${pids[$1]}" 2>/dev/null || true
}

"$crw" pair init 127.77.0.2 --here 127.77.0.1 --pair-folder "$work/0" --invitation "$work/invitation" >/dev/null
"$crw" pair join "$work/invitation" --pair-folder "$work/1" >/dev/null
start 0
await 0 'the session is at'
start 1
first=0
for ((n = 1; n <= losses; n++)); do
    second=$((1 - first))
    await "$second" 'goes on with it by itself'
    await "$second" 'standby: ready'
    began=$(date +%s%N)
    cut_power "$first"
    await "$second" 'the session is at'
    took=$((($(date +%s%N) - began) / 1000000))
    echo "$took" >>"$work/times"
    echo "power loss $n: $took ms"
    if [ "$n" -lt "$losses" ]; then
        "$crw" pair rejoin --pair-folder "$work/$first" >/dev/null
        start "$first"
        first=$second
    fi
done
sort -n "$work/times" | awk '{ t[NR] = $1 } END { printf "%d losses of power: median %d ms, p95 %d ms, longest %d ms\n", NR, t[int((NR + 1) / 2)], t[int(NR * 0.95 + 0.999)], t[NR] }'

#!/bin/bash
# Prints where the tests that run at present stand: of each test process of Gradle the threads that are in code of the project, with their upper frames.
# For a build that takes longer than it should: `.ci/run` calls it after an hour. Needs the jcmd of a JDK.
set -u
jcmd="${JAVA_HOME:+$JAVA_HOME/bin/}jcmd"
"$jcmd" -l | grep 'Gradle Test Executor' | while read -r pid name; do
    echo "== process $pid, ${name##*GradleWorkerMain }, in $(readlink "/proc/$pid/cwd")"
    "$jcmd" "$pid" Thread.print 2>&1 | awk '
        BEGIN { RS = "" }
        /org\.sami/ && /Test worker|ForkJoinPool|"main"/ {
            lines = split($0, line, "\n")
            for (i = 1; i <= lines && i <= 24; i++) print line[i]
            print ""
        }'
done
exit 0

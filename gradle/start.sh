#!/bin/sh
#
# Starts @name@ with the Java of JAVA_HOME, or else with the one on the PATH.
#
# JAVA_OPTS and @variable@_OPTS hold options for Java, with spaces between them. Classes are taken from an archive (class-data sharing), so
# that they need not be loaded and verified anew: from the one that the build made for its own Java, or from one that is made in the
# background, once, for another Java, in $XDG_CACHE_HOME/sami (~/.cache/sami). Without either the program is only slower.
# @variable@_ARCHIVE=off goes without.

script=$0
while [ -h "$script" ]; do
    target=$(readlink "$script")
    case $target in
        /*) script=$target ;;
        *) script=$(dirname "$script")/$target ;;
    esac
done
home=$(cd "$(dirname "$script")/.." && pwd -P) || exit 4
lib=$home/lib
classpath=@classpath@

if [ -n "${JAVA_HOME:-}" ]; then
    java=$JAVA_HOME/bin/java
    jdk=$JAVA_HOME
else
    java=$(command -v java)
    jdk=$(readlink -f "$java" 2>/dev/null)
    jdk=${jdk%/bin/java}
fi
if [ ! -x "$java" ]; then
    echo "@name@: there is no Java at '$java'; set JAVA_HOME to a JDK 17 or newer" >&2
    exit 4
fi

# Without a locale Java takes every name of a file, and every text, for ASCII.
case ${LC_ALL:-${LC_CTYPE:-${LANG:-}}} in
    '' | C | POSIX) LC_ALL=C.UTF-8 && export LC_ALL ;;
esac

# The best machine code is worth its making where a program runs long; the JVM makes it ten times as late as by its own choice, else most
# of a short run is spent on it. What ends at once goes without.
case ${1:-} in
    @long@)
        compiler='-XX:Tier4InvocationThreshold=50000 -XX:Tier4MinInvocationThreshold=6000
            -XX:Tier4CompileThreshold=150000 -XX:Tier4BackEdgeThreshold=400000'
        ;;
    *) compiler=-XX:TieredStopAtLevel=1 ;;
esac
# A run makes some GB of short-lived objects: with room for more of them they are collected seldom, and caches stay warm.
case ${1:-} in
    @large@) heap=-Xmn300m ;;
    *) heap= ;;
esac
flags='-XX:+UseSerialGC -Xshare:auto -XX:-UsePerfData --enable-native-access=ALL-UNNAMED@flags@'
# What the JVM has to say goes to standard error, which programs do not parse; that an archive does not fit is nobody's trouble.
flags="$flags -Xlog:disable -Xlog:all=warning:stderr -Xlog:cds*=off:stderr"

# make_archive FILE: has a process load what the program needs, and keeps its classes. Another name until it is whole. It is made of a list
# of classes, without those of lambdas, and not at the end of that process: Java 17 dies of some lambdas there.
make_archive() {
    new=$1.$$
    # shellcheck disable=SC2086 # several words are meant
    "$java" $flags -Djava.awt.headless=true -XX:DumpLoadedClassList="$new.all" -cp "$classpath" @archive@ &&
        grep -v '@lambda-proxy' "$new.all" >"$new.list" &&
        "$java" $flags -Xshare:dump -XX:SharedClassListFile="$new.list" -XX:SharedArchiveFile="$new" -cp "$classpath" &&
        mv -f "$new" "$1"
    made=$?
    rm -f "$new" "$new.all" "$new.list"
    return $made
}

if [ "${@variable@_ARCHIVE:-}" = build ]; then
    make_archive "$lib/@name@.jsa" </dev/null >/dev/null 2>&1 && cp "$jdk/release" "$lib/@name@.jsa.release"
    exit
fi

set -- -cp "$classpath" @main@ "$@"
if [ "${@variable@_ARCHIVE:-}" != off ] && [ -r "$jdk/release" ]; then
    if cmp -s "$jdk/release" "$lib/@name@.jsa.release"; then
        archive=$lib/@name@.jsa
    else
        cache=${XDG_CACHE_HOME:-${HOME:-/nonexistent}/.cache}/sami
        # Without the first line, the number of blocks: it grows while a system still writes what was copied.
        key=$({ cat "$jdk/release"; ls -ln "$lib" | tail -n +2; echo "$lib"; } | cksum)
        archive=$cache/@name@-${key%% *}.jsa
        if [ ! -e "$archive" ] && mkdir -p "$cache" 2>/dev/null && mkdir "$archive.making" 2>/dev/null; then
            (trap 'rmdir "$archive.making"' EXIT; make_archive "$archive") </dev/null >/dev/null 2>&1 &
        fi
    fi
    if [ -r "$archive" ]; then
        set -- "-XX:SharedArchiveFile=$archive" "$@"
    fi
fi

# shellcheck disable=SC2086 # several words are meant
exec "$java" $flags $compiler $heap ${JAVA_OPTS:-} ${@variable@_OPTS:-} "$@"

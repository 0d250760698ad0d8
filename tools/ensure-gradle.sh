#!/bin/sh
# Called by ./gradlew (Unix) before anything else: sees that the Gradle distribution of the wrapper is in place.
# In the ordinary way the wrapper downloads it. Where that fails but Maven and its repository are there,
# tools/bootstrap-gradle.sh makes it. Once it is in place, this costs one file test.
# Usage: ensure-gradle.sh JAVA WRAPPER_JAR
set -u
here=$(cd "$(dirname "$0")" && pwd -P)

version=$("$1" -version 2>&1 | sed -n 's/.* version "\([0-9]*\).*/\1/p' | head -n 1)
if [ "${version:-0}" -lt 17 ] || [ "$version" -gt 22 ]; then
    echo "SAMI is built with JDK 17 (to 22 at most: Gradle 8.8 knows no later one); $1 is version ${version:-unknown}." >&2
    echo "Set JAVA_HOME to a JDK 17." >&2
    exit 1
fi

set -- "$1" "$2" "${GRADLE_USER_HOME:-$HOME/.gradle}/wrapper/dists/gradle-8.8-bin"
for ok in "$3"/*/gradle-8.8-bin.zip.ok; do
    [ -f "$ok" ] && exit 0
done

log=$(mktemp) || exit 1
trap 'rm -f "$log"' EXIT
echo "Gradle 8.8 is not here yet: asking for its distribution." >&2
"$1" -classpath "$2" -Dorg.gradle.appname=gradlew org.gradle.wrapper.GradleWrapperMain --version >"$log" 2>&1 && exit 0

if ! command -v bash >/dev/null || ! command -v mvn >/dev/null; then
    cat "$log" >&2
    echo "Gradle 8.8 could not be downloaded (above), and it cannot be made either: that needs bash, Maven (mvn) and" >&2
    echo "a JDK 17. Install Maven, or let this machine reach the address in gradle/wrapper/gradle-wrapper.properties." >&2
    exit 1
fi
echo "The distribution cannot be downloaded here: making Gradle 8.8 from its Maven artifacts (once, under a minute)." >&2
if ! bash "$here/bootstrap-gradle.sh" >"$log" 2>&1; then
    cat "$log" >&2
    echo "Gradle 8.8 could not be made (above). Does \`mvn\` reach its repository, and is it run by a JDK 17?" >&2
    exit 1
fi

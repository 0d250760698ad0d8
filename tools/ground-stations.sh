#!/bin/bash
# Installs ground stations of other makers for the tests of boat-mavlink: a Python in build/stations with MAVProxy, MAVSDK and pymavlink.
# Does nothing where it is there. Without a network or Python it fails, and those tests are skipped.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
place=build/stations
[ -e "$place/.complete" ] && exit 0
rm -rf "$place"
python3 -m venv "$place"
# MAVProxy's own list brings OpenCV and wxPython for windows that no test opens. Newer MAVSDKs have another interface.
"$place/bin/pip" install --quiet --disable-pip-version-check 'mavsdk==3.17.4' pymavlink==2.4.50 pyserial pynmeagps numpy
"$place/bin/pip" install --quiet --disable-pip-version-check --no-deps MAVProxy==1.8.75
touch "$place/.complete"

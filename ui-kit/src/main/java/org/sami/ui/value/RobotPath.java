package org.sami.ui.value;

import org.sami.spn.value.GeoPath;

/** A path that a solution has for a robot. */
record RobotPath(String robot, GeoPath path) {}

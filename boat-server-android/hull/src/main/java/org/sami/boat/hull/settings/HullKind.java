package org.sami.boat.hull.settings;

/** How a hull is driven. */
public enum HullKind {
    /** A motor on each side; the difference of their thrusts turns the hull. */
    DIFFERENTIAL,
    /** One motor or fan without reverse thrust, and a rudder. */
    RUDDER
}

package org.sami.mavlink.vehicle;

import java.util.Optional;

/**
 * What a vehicle's GPS receiver has.
 *
 * @param fix in words: {@code no GPS}, {@code no fix}, {@code 2D}, {@code 3D}, {@code DGPS}, {@code RTK float}, {@code RTK fixed}
 * @param satellites how many it sees; empty where it does not say
 */
public record GpsState(String fix, Optional<Integer> satellites) {}

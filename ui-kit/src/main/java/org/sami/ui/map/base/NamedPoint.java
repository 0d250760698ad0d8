package org.sami.ui.map.base;

import org.sami.spn.value.GeoPoint;

/** A point with its feature's name; empty text where it has none. */
public record NamedPoint(String name, GeoPoint at) {}

package org.sami.spn.model;

/** Where a vertex is drawn, in drawing units at scale 1: x to the right, y downwards. */
public record LayoutPoint(double x, double y) {}

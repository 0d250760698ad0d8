package org.sami.ui.geo;

/** What somebody draws on a map. */
public enum GeoShape {
    /** One point. */
    POINT("point", 1),
    /** Any number of points, each for itself. */
    POINTS("list of points", 1),
    /** Points in the order in which they are visited. */
    PATH("path", 2),
    /** The inside of an outline. */
    AREA("area", 3);

    private final String word;
    private final int leastPoints;

    GeoShape(String word, int leastPoints) {
        this.word = word;
        this.leastPoints = leastPoints;
    }

    /** What people call it: "list of points". */
    public String word() {
        return word;
    }

    /** How many points it has at least. */
    public int leastPoints() {
        return leastPoints;
    }
}

package org.sami.ui.map;

/** The rectangles of a map that are painted on already: names ask it where they hide least. For one painting, in pixels. */
class MapLabels {
    private static final int VALUES_PER_LABEL = 5;
    private static final double OF_TEXT = 8; // a letter that is hidden makes another name

    private double[] edges = new double[320]; // left, top, right, bottom and weight of each
    private int used;

    /** Forgets all. */
    void clear() {
        used = 0;
    }

    /** A rectangle that is painted on. */
    void add(double left, double top, double width, double height) {
        add(left, top, width, height, 1);
    }

    /** A rectangle in which something is written: whatever hides a part of it hides so much more. */
    void addText(double left, double top, double width, double height) {
        add(left, top, width, height, OF_TEXT);
    }

    private void add(double left, double top, double width, double height, double weight) {
        if (used + VALUES_PER_LABEL > edges.length) {
            edges = java.util.Arrays.copyOf(edges, 2 * edges.length);
        }
        edges[used++] = left;
        edges[used++] = top;
        edges[used++] = left + width;
        edges[used++] = top + height;
        edges[used++] = weight;
    }

    /**
     * The first of the places at which a plate hides nothing; else the one at which it hides least.
     *
     * @param corners x and y of the left upper corner of each place
     * @param most how much of the plate may hide something, as a part of it; 1 = any of it
     * @return the number of the place, from 0; -1 where each hides more
     */
    int place(double[] corners, double width, double height, double most) {
        double least = most >= 1 ? Double.POSITIVE_INFINITY : Math.nextUp(most * width * height);
        int best = -1;
        for (int i = 0; i < corners.length && least > 0; i += 2) {
            double hidden = hidden(corners[i], corners[i + 1], width, height, least);
            if (hidden < least) {
                least = hidden;
                best = i / 2;
            }
        }
        return best;
    }

    /** Whether a plate hides nothing there. */
    boolean isFree(double left, double top, double width, double height) {
        return hidden(left, top, width, height, Double.MIN_VALUE) == 0;
    }

    /** How much a rectangle would hide, in square pixels, of text many times as much; counted until it is not less than {@code enough}. */
    private double hidden(double left, double top, double width, double height, double enough) {
        double hidden = 0;
        for (int i = 0; i < used && hidden < enough; i += VALUES_PER_LABEL) {
            double across = Math.min(left + width, edges[i + 2]) - Math.max(left, edges[i]);
            if (across > 0) {
                double down = Math.min(top + height, edges[i + 3]) - Math.max(top, edges[i + 1]);
                hidden += edges[i + 4] * across * Math.max(0, down);
            }
        }
        return hidden;
    }
}

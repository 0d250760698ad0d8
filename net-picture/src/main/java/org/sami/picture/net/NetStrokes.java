package org.sami.picture.net;

import java.awt.BasicStroke;

/**
 * The lines of a net in drawing units: as wide as drawn, and on a small net as wide as they have to be to be seen.
 *
 * @param thin edges
 * @param dashed edges without a condition
 * @param rim places
 * @param thick what is selected, spoken of or active
 */
record NetStrokes(BasicStroke thin, BasicStroke dashed, BasicStroke rim, BasicStroke thick) {
    private static final double THIN = 1.4;
    private static final double RIM = 2;
    private static final double THICK = 3.5;
    private static final double LEAST_THIN_PX = 1.2;
    private static final double LEAST_RIM_PX = 1.6;
    private static final double LEAST_THICK_PX = 2.6;

    /**
     * The lines at a size of the net.
     *
     * @param zoom how large it is shown, 1 at its own size
     */
    static NetStrokes at(double zoom) {
        float thin = (float) Math.max(THIN, LEAST_THIN_PX / zoom);
        return new NetStrokes(
                new BasicStroke(thin),
                new BasicStroke(
                        thin,
                        BasicStroke.CAP_BUTT,
                        BasicStroke.JOIN_ROUND,
                        10,
                        new float[] {4.3f * thin, 3.6f * thin},
                        0),
                new BasicStroke((float) Math.max(RIM, LEAST_RIM_PX / zoom)),
                new BasicStroke((float) Math.max(THICK, LEAST_THICK_PX / zoom)));
    }
}

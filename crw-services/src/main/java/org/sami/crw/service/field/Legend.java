package org.sami.crw.service.field;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * What the colours of a field mean.
 *
 * @param least the least value
 * @param greatest the greatest value
 * @param unit of the values; empty for none
 * @param marks round values between both, in order; contours are drawn at these
 */
public record Legend(double least, double greatest, String unit, List<Double> marks) {
    private static final int MARKS = 5;

    public Legend {
        Objects.requireNonNull(unit, "unit");
        marks = List.copyOf(marks);
    }

    /** The legend of a grid, with up to about five marks at steps of 1, 2 or 5 times a power of ten. */
    public static Legend of(FieldGrid grid, String unit) {
        List<Double> marks = new ArrayList<>();
        double range = grid.greatest() - grid.least();
        if (range > 0) {
            double step = roundStep(range / MARKS);
            for (double n = Math.ceil(grid.least() / step); n * step <= grid.greatest(); n++) {
                marks.add(n * step);
            }
        }
        return new Legend(grid.least(), grid.greatest(), unit, marks);
    }

    private static double roundStep(double rough) {
        double power = Math.pow(10, Math.floor(Math.log10(rough)));
        double part = rough / power;
        return power * (part <= 1 ? 1 : part <= 2 ? 2 : part <= 5 ? 5 : 10);
    }
}

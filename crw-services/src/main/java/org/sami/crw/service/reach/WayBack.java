package org.sami.crw.service.reach;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * With how much charge a boat comes home from the end of its way, where that is little.
 *
 * @param words a sentence without its full stop
 * @param isSure whether the charge is sure to last for the way and the way home
 */
public record WayBack(String words, boolean isSure) {
    /** What a boat brings home that need not be spoken of, in percent. */
    public static final double PLENTY_PERCENT = 30;

    public WayBack {
        Objects.requireNonNull(words, "words");
    }

    /**
     * Looks at a way; empty for a boat that brings plenty home, and for one of which position or charge are not known. A boat whose charge is not sure
     * to last for the way itself is another matter ({@link WayCheck}).
     *
     * @param home where the boat returns to
     */
    public static Optional<WayBack> of(Way way, GeoPoint home) {
        if (way.from().isEmpty() || way.charge().isEmpty() || way.points().isEmpty()) {
            return Optional.empty();
        }
        GeoPoint from = way.from().get();
        GeoPoint end = way.points().get(way.points().size() - 1);
        double outM = Geodesy.lengthM(from, Detour.along(from, way.points(), way.water()));
        Optional<Water> around = way.water().map(water -> water.leaving(home));
        double homeM = Geodesy.lengthM(end, Detour.along(end, List.of(home), around));
        Charge charge = way.charge().get();
        double percent = charge.percent();
        double asFarAsM = outM + charge.outwardM(homeM);
        double left = percent - charge.usedPercent(asFarAsM);
        double sureM = charge.sureM();
        if (left >= PLENTY_PERCENT || outM > sureM) {
            return Optional.empty();
        }
        return Optional.of(
                asFarAsM <= sureM
                        ? new WayBack(
                                String.format(
                                        Locale.ROOT,
                                        "%s comes home from its way with about %.0f %% of charge",
                                        way.boat(),
                                        left),
                                true)
                        : new WayBack(
                                String.format(
                                        Locale.ROOT,
                                        "%s may not come home from the end of its way: %.0f m there and %.0f m back,"
                                                + " and its charge of %.0f %% is sure to last for %.0f m",
                                        way.boat(),
                                        outM,
                                        homeM,
                                        percent,
                                        sureM),
                                false));
    }
}

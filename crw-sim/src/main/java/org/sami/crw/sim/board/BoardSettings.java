package org.sami.crw.sim.board;

import java.util.Objects;
import org.sami.boat.hull.settings.HullKind;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.spn.value.GeoPoint;

/**
 * What is set for a simulated board and the hull behind it.
 *
 * @param at where the hull lies at the start
 * @param seed of all that is random
 * @param kind whether the hull has two motors or a rudder
 * @param hull what it can do
 * @param conditions of its water and its instruments
 * @param fieldSeed of what there is to be measured
 * @param hasCompass whether its receiver sends headings
 * @param faults what goes wrong
 */
public record BoardSettings(
        GeoPoint at,
        long seed,
        HullKind kind,
        HullConfig hull,
        Conditions conditions,
        long fieldSeed,
        boolean hasCompass,
        BoardFaults faults) {

    /** Refuses what is missing. */
    public BoardSettings {
        Objects.requireNonNull(at, "at");
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(hull, "hull");
        Objects.requireNonNull(conditions, "conditions");
        Objects.requireNonNull(faults, "faults");
    }

    /** A differential hull with a compass on calm water, on a good cable. */
    public static BoardSettings at(GeoPoint at, long seed) {
        return new BoardSettings(
                at, seed, HullKind.DIFFERENTIAL, HullConfig.DEFAULT, Conditions.CALM, 1, true, BoardFaults.NONE);
    }

    /** The same with another kind of hull. */
    public BoardSettings with(HullKind other) {
        return new BoardSettings(at, seed, other, hull, conditions, fieldSeed, hasCompass, faults);
    }

    /** The same on other water. */
    public BoardSettings on(Conditions water) {
        return new BoardSettings(at, seed, kind, hull, water, fieldSeed, hasCompass, faults);
    }

    /** The same without a compass. */
    public BoardSettings withoutCompass() {
        return new BoardSettings(at, seed, kind, hull, conditions, fieldSeed, false, faults);
    }

    /** The same with other faults. */
    public BoardSettings failing(BoardFaults others) {
        return new BoardSettings(at, seed, kind, hull, conditions, fieldSeed, hasCompass, others);
    }
}

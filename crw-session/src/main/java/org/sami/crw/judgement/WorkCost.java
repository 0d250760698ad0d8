package org.sami.crw.judgement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.path.TurningCircle;
import org.sami.crw.service.reach.Charge;
import org.sami.crw.service.water.Water;
import org.sami.session.api.Judgement.Remark;
import org.sami.spn.value.GeoPoint;

/** What the ways of some boats take: length, time and charge, and whose charge is not sure to last. */
final class WorkCost {
    private static final int NAMED = 3;

    private final List<Leg> legs = new ArrayList<>();
    private final boolean swaps;

    /**
     * What one boat would drive.
     *
     * @param outM to the end of its way
     * @param turnsM what it drives in addition where it turns
     * @param homeM from there home; empty where its home is not known
     */
    private record Leg(JudgedBoat boat, double outM, double turnsM, Optional<Double> homeM) {
        double usedPercent() {
            return boat.charge().orElse(Charge.usual(0)).usedPercent(outM);
        }

        double seconds() {
            return (outM + turnsM) / boat.cruiseMps();
        }

        /** Whether the charge is sure to last for the way; true where the charge is not known. */
        boolean lasts() {
            return outM <= boat.sureM();
        }

        boolean comesHome() {
            return outM + homeM.orElse(0.0) <= boat.sureM();
        }

        /** In percent of full; 0 where it is not known. */
        double chargePercent() {
            return boat.charge().map(Charge::percent).orElse(0.0);
        }
    }

    /**
     * Nobody drives yet.
     *
     * @param swaps whether batteries are swapped on the way, so that charges need not last for the ways home
     */
    WorkCost(boolean swaps) {
        this.swaps = swaps;
    }

    /** Adds what a boat drives: so far, by these points. */
    void add(JudgedBoat boat, double outM, List<GeoPoint> way, Optional<Water> water) {
        GeoPoint end = way.get(way.size() - 1);
        Optional<Double> homeM = boat.home().map(home -> {
            Optional<Water> around = water.map(one -> one.leaving(home));
            return Geodesy.lengthM(end, Detour.along(end, List.of(home), around));
        });
        List<GeoPoint> whole = Stream.concat(boat.from().stream(), way.stream()).toList();
        legs.add(new Leg(boat, outM, boat.turningRadiusM() * TurningCircle.perRadius(whole), homeM));
    }

    /** Adds a boat that follows points from where it is; one of which it is not known where it is is left out. */
    void add(JudgedBoat boat, List<GeoPoint> points, Optional<Water> water) {
        if (boat.from().isPresent() && !points.isEmpty()) {
            GeoPoint from = boat.from().get();
            double outM = Geodesy.lengthM(from, Detour.along(from, points, water));
            add(boat, outM, points, water);
        }
    }

    /** What it takes, and whose charge does not last. */
    List<Remark> remarks() {
        List<Remark> remarks = new ArrayList<>();
        if (!legs.isEmpty()) {
            remarks.add(Remark.cost(cost()));
            tooFar().ifPresent(remarks::add);
            if (!swaps) {
                notHome().ifPresent(remarks::add);
            }
        }
        return remarks;
    }

    private String cost() {
        Leg longest = legs.stream().max(Comparator.comparingDouble(Leg::outM)).orElseThrow();
        String most = Amounts.length(longest.outM()) + ", about " + Amounts.time(longest.seconds()) + ", "
                + charge(longest.usedPercent()) + " of a full charge";
        if (legs.size() == 1) {
            return longest.boat().name() + ": " + most;
        }
        double all = legs.stream().mapToDouble(Leg::outM).sum();
        return legs.size() + " boats: " + Amounts.length(all) + " together; the longest way is "
                + longest.boat().name() + "'s, " + most;
    }

    private static String charge(double percent) {
        return percent < 1 ? "under 1 %" : String.format(Locale.ROOT, "%,.0f %%", percent);
    }

    private Optional<Remark> tooFar() {
        List<Leg> some = legs.stream().filter(leg -> !leg.lasts()).toList();
        if (some.isEmpty()) {
            return Optional.empty();
        }
        if (swaps) {
            return Optional.of(Remark.cost("Batteries are to be swapped on the way of " + names(some)));
        }
        Leg worst = some.stream()
                .max(Comparator.comparingDouble(leg -> leg.outM() - leg.boat().sureM()))
                .orElseThrow();
        return Optional.of(Remark.doubt(String.format(
                Locale.ROOT,
                "The way of %s is longer than the charge lasts: %s has %s to go, and its charge of %.0f %% is sure to"
                        + " last for %s",
                names(some),
                worst.boat().name(),
                Amounts.length(worst.outM()),
                worst.chargePercent(),
                Amounts.length(worst.boat().sureM()))));
    }

    private Optional<Remark> notHome() {
        List<Leg> some =
                legs.stream().filter(leg -> leg.lasts() && !leg.comesHome()).toList();
        if (some.isEmpty()) {
            return Optional.empty();
        }
        Leg worst = some.stream()
                .max(Comparator.comparingDouble(
                        leg -> leg.outM() + leg.homeM().orElse(0.0) - leg.boat().sureM()))
                .orElseThrow();
        return Optional.of(Remark.doubt(String.format(
                Locale.ROOT,
                "%s may not come home: %s has %s to go and %s back, and its charge of %.0f %% is sure to last for %s",
                names(some),
                worst.boat().name(),
                Amounts.length(worst.outM()),
                Amounts.length(worst.homeM().orElse(0.0)),
                worst.chargePercent(),
                Amounts.length(worst.boat().sureM()))));
    }

    private static String names(List<Leg> some) {
        String first = some.stream().limit(NAMED).map(leg -> leg.boat().name()).collect(Collectors.joining(", "));
        return some.size() <= NAMED ? first : first + " and " + (some.size() - NAMED) + " more";
    }

    /** Boats by their names. */
    static Map<String, JudgedBoat> byName(List<JudgedBoat> boats) {
        Map<String, JudgedBoat> named = new LinkedHashMap<>();
        boats.forEach(boat -> named.put(boat.name(), boat));
        return named;
    }
}

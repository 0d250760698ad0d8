package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/** What an algorithm says to a {@link PathProblem}: a way, or that there is none. */
public sealed interface PathAnswer {
    /** A distance that is nearer by so much, in metres, is kept: corners of ways stand a little off. */
    double SLACK_M = 0.1;

    /** So many times the shortest way is a longer one. */
    double LONGER = 1.05;

    /** How many straight legs were held against what is forbidden: the measure of how much was computed. */
    long legsTested();

    /**
     * A way.
     *
     * @param points without the start, with the goal
     * @param lengthM along the surface, from the start
     * @param clearanceM least distance of the whole way from forbidden areas; infinite where there are none
     * @param wantedM intended distance from them, where there is room
     * @param shortestM length of the shortest way that a boat can follow
     * @param method the algorithm's name
     */
    record Way(
            List<GeoPoint> points,
            double lengthM,
            double clearanceM,
            double wantedM,
            double shortestM,
            String method,
            long legsTested)
            implements PathAnswer {
        public Way {
            points = List.copyOf(points);
            Objects.requireNonNull(method, "method");
        }

        /** The way of a length that is the shortest, or that is taken for it. */
        Way than(double shortest) {
            return new Way(points, lengthM, clearanceM, wantedM, shortest, method, legsTested);
        }

        /**
         * How far it keeps off, and what that costs, for people: "keeps 8.0 m where there is room, 5.2 m near 45.70012,10.72034; 1.3 times the
         * shortest". Empty in open water.
         *
         * @param from where it begins
         */
        public Optional<String> words(GeoPoint from, Water water) {
            if (!Double.isFinite(clearanceM)) {
                return Optional.empty();
            }
            List<GeoPoint> whole = new ArrayList<>(List.of(from));
            whole.addAll(points);
            GeoPoint nearest = water.nearest(whole);
            String kept = clearanceM >= wantedM - SLACK_M
                    ? String.format(Locale.ROOT, "keeps %.1f m", Math.max(clearanceM, wantedM))
                    : String.format(
                            Locale.ROOT,
                            "keeps %.1f m where there is room, %.1f m near %.5f,%.5f",
                            wantedM,
                            clearanceM,
                            nearest.latDeg(),
                            nearest.lonDeg());
            double times = lengthM / shortestM;
            return Optional.of(
                    times < LONGER ? kept : String.format(Locale.ROOT, "%s; %.1f times the shortest", kept, times));
        }
    }

    /** No way; the reason is a sentence without its full stop. */
    record NoWay(String reason, long legsTested) implements PathAnswer {
        public NoWay {
            Objects.requireNonNull(reason, "reason");
        }
    }
}

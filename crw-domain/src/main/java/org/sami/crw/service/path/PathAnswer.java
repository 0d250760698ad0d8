package org.sami.crw.service.path;

import java.util.List;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/** What an algorithm says to a {@link PathProblem}: a way, or that there is none. */
public sealed interface PathAnswer {
    /** How many straight legs were held against what is forbidden: the measure of how much was computed. */
    long legsTested();

    /**
     * A way.
     *
     * @param points without the start, with the goal
     * @param lengthM along the surface, from the start
     * @param clearanceM least distance of the whole way from what is forbidden; infinite where nothing is
     * @param method the algorithm's name
     */
    record Way(List<GeoPoint> points, double lengthM, double clearanceM, String method, long legsTested)
            implements PathAnswer {
        public Way {
            points = List.copyOf(points);
            Objects.requireNonNull(method, "method");
        }
    }

    /** No way; the reason is a sentence without its full stop. */
    record NoWay(String reason, long legsTested) implements PathAnswer {
        public NoWay {
            Objects.requireNonNull(reason, "reason");
        }
    }
}

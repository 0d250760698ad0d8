package org.sami.crw.mavlink;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.Predicate;
import org.sami.mavlink.vehicle.VehicleEvent;

/**
 * What a vehicle reports of its way along its list, in order, until it can be judged: by a report that leaves waypoints out, or comes from far away, it is not known whether somebody
 * else has sent the vehicle there or reports were lost, before the vehicle has said where it was then. For the gateway's thread.
 */
final class UnjudgedReports {
    private static final int MOST = 100; // more does not come within the time
    private static final long WITHOUT_PLACE_MS = 5_000; // one that has not said where it is for so long is believed

    private final Deque<Report> waiting = new ArrayDeque<>();

    private record Report(VehicleEvent event, long heardMs) {}

    /** Takes a report that concerns a mission; of more than can be kept the first is left out, as one that is lost. */
    void add(VehicleEvent event) {
        if (event instanceof VehicleEvent.ItemCurrent current) {
            waiting.addLast(new Report(event, current.heardMs()));
        } else if (event instanceof VehicleEvent.ItemReached reached) {
            waiting.addLast(new Report(event, reached.heardMs()));
        }
        if (waiting.size() > MOST) {
            waiting.removeFirst();
        }
    }

    /** They are of another drive. */
    void forget() {
        waiting.clear();
    }

    /**
     * The next report that can be judged; empty where there is none yet.
     *
     * @param isDoubtful whether a report is judged by where the vehicle was
     * @param nowMs when the vehicle was heard last, on the base's clock
     */
    Optional<VehicleEvent> next(Predicate<VehicleEvent> isDoubtful, VehicleTrail trail, long nowMs) {
        return Optional.ofNullable(waiting.peekFirst())
                .filter(report -> !isDoubtful.test(report.event())
                        || trail.isKnownAfter(report.heardMs())
                        || nowMs - report.heardMs() > WITHOUT_PLACE_MS)
                .map(report -> waiting.removeFirst().event());
    }
}

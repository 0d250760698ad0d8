package org.sami.crw.sim.run.incident;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.sami.crw.sim.run.incident.IncidentKind.PlannedIncident;
import org.sami.crw.sim.run.record.BoatState;

/** Incidents in the order in which they come, each once it has come. For the engine's thread. */
final class IncidentQueue {
    private static final long LOOK_MILLIS = 200;

    private final IncidentKind kind;
    private final CriticalBoats critical;
    private final Supplier<List<BoatState>> reported;
    private final BooleanSupplier isNoticing;
    private final Deque<PlannedIncident> planned = new ArrayDeque<>();
    private final Set<String> inCare = new HashSet<>(); // boats of earlier incidents that are still inside
    private long nextLookMillis;

    /**
     * Incidents of a run.
     *
     * @param reported gives the boats as they report themselves
     * @param isNoticing whether the operator would notice an incident at a drawn time now; it waits until then
     */
    IncidentQueue(
            IncidentKind kind, CriticalBoats critical, Supplier<List<BoatState>> reported, BooleanSupplier isNoticing) {
        this.kind = kind;
        this.critical = critical;
        this.reported = reported;
        this.isNoticing = isNoticing;
        if (kind instanceof IncidentKind.AtTimes times) {
            planned.addAll(times.incidents());
        }
    }

    /**
     * An incident that has come and is to be resolved now.
     *
     * @param sinceStartMillis time since the first mission's start
     */
    Optional<PlannedIncident> due(long sinceStartMillis) {
        if (kind instanceof IncidentKind.AtTimes) {
            return planned.isEmpty() || planned.peek().afterMillis() > sinceStartMillis || !isNoticing.getAsBoolean()
                    ? Optional.empty()
                    : Optional.of(planned.poll());
        }
        if (kind instanceof IncidentKind.CriticalBattery) {
            return critical.next().map(boat -> new PlannedIncident(sinceStartMillis, List.of(boat)));
        }
        return kind instanceof IncidentKind.BoatsInside inside && sinceStartMillis >= nextLookMillis
                ? gathered(inside, sinceStartMillis)
                : Optional.empty();
    }

    private Optional<PlannedIncident> gathered(IncidentKind.BoatsInside inside, long nowMillis) {
        nextLookMillis = nowMillis + LOOK_MILLIS;
        List<String> boats = reported.get().stream()
                .filter(boat -> inside.area().contains(boat.eastM(), boat.northM()))
                .map(BoatState::id)
                .toList();
        inCare.retainAll(boats);
        if (boats.size() < inside.boats() || inCare.containsAll(boats)) {
            return Optional.empty();
        }
        List<String> others =
                boats.stream().filter(boat -> !inCare.contains(boat)).toList();
        inCare.addAll(boats);
        return Optional.of(new PlannedIncident(nowMillis, others));
    }

    /** Number of planned incidents that have not come. */
    int left() {
        return planned.size();
    }
}

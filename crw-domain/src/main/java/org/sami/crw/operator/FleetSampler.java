package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.BiConsumer;
import java.util.function.LongSupplier;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.status.LinkState;

/**
 * Takes snapshots of boats: one after what happened to a boat, at most one of each in a period; the last change is caught by
 * {@link #look}. For the fleet's thread.
 */
final class FleetSampler {
    /** Proxies know the time by their ticks, so a silence is known within this; else a silent boat would be new at every look. */
    private static final long HEARD_TOLERANCE_MILLIS = 150;

    private final ProxyRegistry boats;
    private final MissionTitles titles;
    private final LongSupplier nowMillis;
    private final long periodMillis;
    private final BiConsumer<String, Optional<BoatSnapshot>> taken;
    private final Map<String, Seen> seen = new HashMap<>();
    // of the registry: so that all can be looked at ten times a second without being looked up
    private final List<Seen> inOrder = new ArrayList<>();

    private static final class Seen {
        private final BoatProxy boat;
        private long sampledAtMillis = Long.MIN_VALUE / 2;
        private long poseAtMillis;
        private boolean changed = true;
        private Optional<BoatSnapshot> last = Optional.empty();

        Seen(BoatProxy boat) {
            this.boat = boat;
        }
    }

    /**
     * A sampler that has seen no boat.
     *
     * @param periodMillis how long a boat is left alone after a snapshot of it
     * @param taken is given each snapshot that differs from the one before; empty for a boat that is gone
     */
    FleetSampler(
            ProxyRegistry boats,
            MissionTitles titles,
            LongSupplier nowMillis,
            long periodMillis,
            BiConsumer<String, Optional<BoatSnapshot>> taken) {
        this.boats = boats;
        this.titles = titles;
        this.nowMillis = nowMillis;
        this.periodMillis = periodMillis;
        this.taken = taken;
    }

    /** Something happened to a boat. */
    void happened(FleetEvent event) {
        if (event.boat().isEmpty()) {
            return;
        }
        if (event instanceof FleetEvent.Removed) {
            gone(event.boat());
            return;
        }
        Seen known = seen.get(event.boat());
        if (known == null) {
            known = boats.find(event.boat()).map(this::begin).orElse(null);
        }
        if (known != null) {
            long now = nowMillis.getAsLong();
            known.changed = true;
            if (event instanceof FleetEvent.StatusReported) {
                known.poseAtMillis = now;
            }
            sampleIfDue(known, now);
        }
    }

    private Seen begin(BoatProxy boat) {
        Seen known = new Seen(boat);
        seen.put(boat.boatId(), known);
        return known;
    }

    /** Time has passed: takes snapshots that are due. To be called once a period. */
    void look() {
        long now = nowMillis.getAsLong();
        int at = 0;
        for (BoatProxy boat : boats.all()) {
            Seen known = inOrder(at++, boat);
            known.changed |= now - known.sampledAtMillis >= 10 * periodMillis; // words count seconds
            sampleIfDue(known, now);
        }
    }

    private Seen inOrder(int at, BoatProxy boat) {
        if (at < inOrder.size() && inOrder.get(at).boat == boat) {
            return inOrder.get(at);
        }
        inOrder.subList(at, inOrder.size()).clear(); // boats have come or gone
        Seen known = seen.get(boat.boatId());
        if (known == null || known.boat != boat) {
            known = begin(boat);
        }
        inOrder.add(known);
        return known;
    }

    private void gone(String boat) {
        if (seen.remove(boat) != null) {
            taken.accept(boat, Optional.empty());
        }
    }

    private void sampleIfDue(Seen known, long now) {
        if (!known.changed || now - known.sampledAtMillis < periodMillis) {
            return;
        }
        known.changed = false;
        known.sampledAtMillis = now;
        BoatSnapshot next = snapshot(known, now);
        if (!known.last.equals(Optional.of(next))) {
            known.last = Optional.of(next);
            taken.accept(known.boat.boatId(), known.last);
        }
    }

    private BoatSnapshot snapshot(Seen known, long now) {
        BoatProxy boat = known.boat;
        Optional<CommandQueueSnapshot.Entry> current = boat.commands().queue().current();
        BoatExplanation why = boat.explain(titles);
        return new BoatSnapshot(
                boat.boatId(),
                boat.status().link(),
                heard(known, now),
                boat.status().pose(),
                known.poseAtMillis,
                boat.status().battery(),
                boat.status().mode(),
                commander(boat, why.cause()),
                current.map(CommandQueueSnapshot.Entry::command),
                current.map(CommandQueueSnapshot.Entry::visited).orElse(0),
                current.map(CommandQueueSnapshot.Entry::points).orElse(0),
                why,
                boat.wayHome());
    }

    private static OptionalLong heard(Seen known, long now) {
        OptionalLong silence = known.boat.silentMs();
        if (silence.isEmpty()) {
            return silence;
        }
        long heard = now - silence.getAsLong();
        OptionalLong before = known.last.map(BoatSnapshot::heardAtMillis).orElse(OptionalLong.empty());
        return before.isPresent() && Math.abs(before.getAsLong() - heard) <= HEARD_TOLERANCE_MILLIS
                ? before
                : OptionalLong.of(heard);
    }

    private static Commander commander(BoatProxy boat, Cause cause) {
        if (boat.isTakenOver()) {
            return Commander.BY_HAND;
        } else if (boat.isCommanding()) {
            return Commander.THIS_BASE;
        }
        return boat.status().link() == LinkState.LINKED && cause == Cause.COMMANDED_ELSEWHERE
                ? Commander.SOMEBODY_ELSE
                : Commander.UNKNOWN;
    }
}

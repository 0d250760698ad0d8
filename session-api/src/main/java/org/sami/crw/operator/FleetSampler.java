package org.sami.crw.operator;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.BiConsumer;
import java.util.function.LongSupplier;
import org.sami.boat.link.BoatMode;
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
import org.sami.crw.proxy.status.StopLatch;

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
    private final Map<String, Seen> seen = new LinkedHashMap<>();

    private static final class Seen {
        private long sampledAtMillis = Long.MIN_VALUE / 2;
        private long poseAtMillis;
        private boolean changed = true;
        private Optional<BoatSnapshot> last = Optional.empty();
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
        Optional<BoatProxy> boat = boats.find(event.boat());
        if (boat.isPresent()) {
            Seen known = seen.computeIfAbsent(event.boat(), id -> new Seen());
            known.changed = true;
            if (event instanceof FleetEvent.StatusReported) {
                known.poseAtMillis = nowMillis.getAsLong();
            }
            sampleIfDue(boat.get(), known);
        }
    }

    /** Time has passed: takes snapshots that are due. To be called once a period. */
    void look() {
        boats.all().forEach(boat -> {
            Seen known = seen.computeIfAbsent(boat.boatId(), id -> new Seen());
            known.changed |= nowMillis.getAsLong() - known.sampledAtMillis >= 10 * periodMillis; // words count seconds
            sampleIfDue(boat, known);
        });
    }

    private void gone(String boat) {
        if (seen.remove(boat) != null) {
            taken.accept(boat, Optional.empty());
        }
    }

    private void sampleIfDue(BoatProxy boat, Seen known) {
        long now = nowMillis.getAsLong();
        if (!known.changed || now - known.sampledAtMillis < periodMillis) {
            return;
        }
        known.changed = false;
        known.sampledAtMillis = now;
        BoatSnapshot next = snapshot(boat, known, now);
        if (!known.last.equals(Optional.of(next))) {
            known.last = Optional.of(next);
            taken.accept(boat.boatId(), known.last);
        }
    }

    private BoatSnapshot snapshot(BoatProxy boat, Seen known, long now) {
        Optional<CommandQueueSnapshot.Entry> current = boat.commands().queue().current();
        BoatExplanation why = boat.explain(titles);
        return new BoatSnapshot(
                boat.boatId(),
                boat.status().link(),
                heard(boat, known, now),
                boat.status().pose(),
                known.poseAtMillis,
                boat.status().battery(),
                boat.status().mode(),
                commander(boat, why.cause()),
                current.map(CommandQueueSnapshot.Entry::command),
                current.map(CommandQueueSnapshot.Entry::visited).orElse(0),
                current.map(CommandQueueSnapshot.Entry::points).orElse(0),
                why,
                boat.drift(),
                stop(boat),
                boat.wayHome(),
                boat.settings().inForce(),
                boat.isFlying());
    }

    /** A stop that is on its way to the boat is none yet. */
    private static StopLatch stop(BoatProxy boat) {
        StopLatch stop = boat.stop();
        boolean confirmed =
                boat.status().mode().filter(BoatMode.FLEET_STOP::equals).isPresent();
        return confirmed || stop.where() == StopLatch.Where.OVERRIDDEN ? stop : StopLatch.NONE;
    }

    private static OptionalLong heard(BoatProxy boat, Seen known, long now) {
        OptionalLong silence = boat.silentMs();
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

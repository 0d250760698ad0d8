package org.sami.crw.mavlink;

import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * What is read of a vehicle's parameters and set in them: which start of its autopilot this is, and what it does when its ground station is lost. For the
 * gateway's thread.
 */
final class VehicleSettings {
    private static final String STARTS = "STAT_BOOTCNT";

    private final MavlinkBase base;
    private final VehicleId id;
    private final Executor thread;
    private final String whose;
    private final VehicleFailsafe failsafe;
    private Optional<String> bootId = Optional.empty();
    private Optional<Long> starts = Optional.empty();
    private int reads;

    /**
     * Begins to read.
     *
     * @param whose tells this vehicle's starts from those of others that had its id; empty where none had
     * @param changed called when what it does without a link is known, or is another
     * @param alarm receives what others have changed, in words for the operator
     */
    VehicleSettings(
            MavlinkBase base,
            VehicleId id,
            String whose,
            boolean flies,
            Executor thread,
            Runnable changed,
            Consumer<String> alarm) {
        this.base = base;
        this.id = id;
        this.whose = whose;
        this.thread = thread;
        failsafe = new VehicleFailsafe(base, id, flies, thread, changed, alarm);
        read();
    }

    /** Reads all again: the autopilot has started again. */
    void read() {
        bootId = Optional.empty();
        starts = Optional.empty();
        int number = ++reads;
        Results.when(
                base.parameter(id, STARTS),
                thread,
                count -> started(number, Math.round(count)),
                why -> started(
                        number,
                        UUID.randomUUID().toString())); // a firmware that does not count: a new one for each base
        failsafe.read();
    }

    private void started(int number, long count) {
        if (number == reads) {
            starts = Optional.of(count);
        }
        started(number, "start " + count);
    }

    /** Its autopilot's clock is behind: reads whether it has started again, and has all know where it has. A firmware that does not count its starts is not asked. */
    void clockBehind() {
        int number = reads;
        starts.ifPresent(before -> Results.when(
                base.parameter(id, STARTS),
                thread,
                count -> {
                    if (number == reads && Math.round(count) != before) {
                        base.restarted(id);
                    }
                },
                unanswered -> {})); // the event comes again
    }

    private void started(int number, String name) {
        if (number == reads) {
            bootId = Optional.of(name + whose);
        }
    }

    /** The id of the autopilot's present start; empty until it is known. */
    Optional<String> bootId() {
        return bootId;
    }

    /** What it does when its ground station is lost, and by which parameters. */
    VehicleFailsafe failsafe() {
        return failsafe;
    }
}

package org.sami.crw.mavlink;

import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.boat.link.LostLinkAction;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * What is read of a vehicle's parameters and set in them: which start of its autopilot this is, and what it does when its ground station is lost. For the
 * gateway's thread.
 *
 * <p>Source: ArduPilot's parameters {@code STAT_BOOTCNT}, {@code FS_GCS_ENABLE} (0 off, 1 on, 2 on but not in AUTO) and {@code FS_ACTION} (0 nothing, 1 RTL,
 * 2 hold, 3 and 4 smart RTL: back along the way that it came, 3 straight home where it does not know that, 5 end, 6 keep the place or hold). Copters have
 * {@code FS_GCS_ENABLE} alone (0 off, 1 RTL, 3 and 4 smart RTL, 5 land, 6 land or RTL, 7 brake or land).
 */
final class VehicleSettings {
    private static final String STARTS = "STAT_BOOTCNT";
    private static final String FAILSAFE = "FS_GCS_ENABLE";
    private static final String ACTION = "FS_ACTION";
    private static final int OFF = 0;
    private static final int RETURNS = 1;
    private static final int HOLDS = 2;
    private static final int SMART_RETURN = 3;
    private static final int SMART_RETURN_OR_HOLD = 4;
    private static final int KEEPS_PLACE = 6;
    private static final int COPTER_LANDS = 5;
    private static final int COPTER_BRAKES = 7;

    private final MavlinkBase base;
    private final VehicleId id;
    private final boolean flies;
    private final Executor thread;
    private final Runnable changed;
    private Optional<String> bootId = Optional.empty();
    private Optional<LostLinkAction> lostLink = Optional.empty();
    private int reads;

    /**
     * Begins to read.
     *
     * @param changed called when what it does without a link is known, or is another
     */
    VehicleSettings(MavlinkBase base, VehicleId id, boolean flies, Executor thread, Runnable changed) {
        this.base = base;
        this.flies = flies;
        this.id = id;
        this.thread = thread;
        this.changed = changed;
        read();
    }

    /** Reads all again: the autopilot has started again. */
    void read() {
        bootId = Optional.empty();
        int number = ++reads;
        Results.when(
                base.parameter(id, STARTS),
                thread,
                count -> started(number, "start " + Math.round(count)),
                why -> started(
                        number,
                        UUID.randomUUID().toString())); // a firmware that does not count: a new one for each base
        readAction();
    }

    private void started(int number, String name) {
        if (number == reads) {
            bootId = Optional.of(name);
        }
    }

    private void readAction() {
        Results.when(base.parameter(id, FAILSAFE), thread, this::readAction, why -> {});
    }

    private void readAction(double failsafe) {
        if (Math.round(failsafe) == OFF) {
            is(LostLinkAction.CONTINUE);
        } else if (flies) {
            is(ofCopter(failsafe));
        } else {
            Results.when(base.parameter(id, ACTION), thread, action -> is(meaning(action)), why -> {});
        }
    }

    private static LostLinkAction meaning(double action) {
        return switch ((int) Math.round(action)) {
            case RETURNS, SMART_RETURN, SMART_RETURN_OR_HOLD -> LostLinkAction.RETURN;
            case KEEPS_PLACE -> LostLinkAction.HOLD;
            case OFF -> LostLinkAction.CONTINUE;
            default -> LostLinkAction.DRIFT; // in its mode HOLD the motors are off
        };
    }

    private static LostLinkAction ofCopter(double failsafe) {
        return switch ((int) Math.round(failsafe)) {
            case COPTER_BRAKES -> LostLinkAction.HOLD;
            case COPTER_LANDS -> LostLinkAction.DRIFT; // nothing keeps its place any longer
            default -> LostLinkAction.RETURN;
        };
    }

    private static int ofCopter(LostLinkAction action) {
        return switch (action) {
            case CONTINUE -> OFF;
            case RETURN -> RETURNS;
            case HOLD -> COPTER_BRAKES;
            case DRIFT -> COPTER_LANDS;
        };
    }

    private void is(LostLinkAction action) {
        lostLink = Optional.of(action);
        changed.run();
    }

    /** The id of the autopilot's present start; empty until it is known. */
    Optional<String> bootId() {
        return bootId;
    }

    /** What it does when its ground station is lost; empty where it does not say. */
    Optional<LostLinkAction> lostLink() {
        return lostLink;
    }

    /** Sets what it does when its ground station is lost; {@code ended} receives why it could not be set, or nothing where it was read back. */
    void setLostLink(LostLinkAction action, Consumer<Optional<String>> ended) {
        if (flies) {
            set(FAILSAFE, ofCopter(action), () -> set(action, ended), ended);
        } else if (action == LostLinkAction.CONTINUE) {
            set(FAILSAFE, OFF, () -> set(action, ended), ended);
        } else {
            int number = switch (action) {
                case RETURN -> SMART_RETURN; // along the way that it came, so around what it drove around
                case HOLD -> KEEPS_PLACE;
                default -> HOLDS;
            };
            set(ACTION, number, () -> set(FAILSAFE, 1, () -> set(action, ended), ended), ended);
        }
    }

    private void set(LostLinkAction action, Consumer<Optional<String>> ended) {
        is(action);
        ended.accept(Optional.empty());
    }

    private void set(String name, int value, Runnable then, Consumer<Optional<String>> ended) {
        Results.when(
                base.setParameter(id, name, value), thread, held -> then.run(), why -> ended.accept(Optional.of(why)));
    }
}

package org.sami.crw.mavlink;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.boat.link.Ack;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.TakePanorama;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.CommandOutcome;
import org.sami.mavlink.command.CommandVerdict;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * The camera that a vehicle's autopilot triggers: whether there is one, and one picture where the vehicle is for each {@link TakePanorama}. It counts as taken once
 * the autopilot reports it: without a camera ArduPilot accepts the older order, and takes none. A camera that is at its last picture still is asked again. For the gateway's thread.
 *
 * <p>Source: ArduPilot's parameter {@code CAM1_TYPE} (0: none) and its message {@code CAMERA_FEEDBACK}, sent once the camera has been triggered.
 */
final class VehicleCamera {
    private static final String TYPE = "CAM1_TYPE";
    private static final long REPORTED_MS = 5_000; // a camera that has not been triggered by then was not
    private static final int TRIES = 5; // some 0.7 s apart: so long the answer to a refused one takes

    private final MavlinkBase base;
    private final VehicleId id;
    private final Executor thread;
    private final Consumer<LinkMessage> broadcast;
    private final Runnable changed;
    private Optional<String> missing;
    private boolean known; // whether there is one
    private Optional<Order> pending = Optional.empty();
    private int reads;
    private int captures; // that were asked for
    private long nowMs;

    /** A picture that is asked for. */
    private static final class Order {
        private final TakePanorama command;
        private final Consumer<LinkMessage> answer;
        private boolean asked; // of the vehicle
        private boolean accepted;
        private long acceptedMs;
        private int tries;
        private Optional<VehicleEvent.PictureTaken> picture = Optional.empty();

        Order(TakePanorama command, Consumer<LinkMessage> answer) {
            this.command = command;
            this.answer = answer;
        }
    }

    /**
     * Whether there is one is not known yet.
     *
     * @param broadcast takes what the vehicle says to the base
     * @param changed called when it is known
     */
    VehicleCamera(MavlinkBase base, VehicleId id, Executor thread, Consumer<LinkMessage> broadcast, Runnable changed) {
        this.base = base;
        this.id = id;
        this.thread = thread;
        this.broadcast = broadcast;
        this.changed = changed;
        missing = Optional.of("vehicle " + id + " has not said yet whether it has a camera (" + TYPE + ")");
    }

    /** A base is there, or the autopilot has started again: asks whether it has one. */
    void read() {
        int number = ++reads;
        Results.when(
                base.parameter(id, TYPE),
                thread,
                type -> known(
                        number,
                        Math.round(type) == 0
                                ? Optional.of("vehicle " + id + " has no camera (" + TYPE + " 0)")
                                : Optional.empty()),
                why -> known(number, Optional.of("vehicle " + id + " does not say whether it has a camera: " + why)));
    }

    private void known(int number, Optional<String> why) {
        if (number != reads) {
            return; // asked again meanwhile
        }
        boolean other = !why.equals(missing);
        boolean first = !known;
        missing = why;
        known = true;
        if (other) {
            changed.run();
        }
        if (first) {
            pending.ifPresent(this::begin);
        }
    }

    /** Why it takes no pictures, in words; empty where it does. */
    Optional<String> missing() {
        return missing;
    }

    /** Takes a picture; the answer comes once it is reported, and then what was taken where. A later order takes the place of one that is not answered. */
    void take(TakePanorama command, Consumer<LinkMessage> answer) {
        pending.ifPresent(before -> end(before, NackReason.STALE, "a later order for a picture came"));
        Order order = new Order(command, answer);
        pending = Optional.of(order);
        if (known) {
            begin(order);
        }
    }

    private void begin(Order order) {
        if (missing.isPresent()) {
            fail(order, missing.get());
        } else {
            trigger(order, VehicleCommand.takePicture(++captures));
        }
    }

    private void trigger(Order order, VehicleCommand by) {
        order.asked = true;
        order.tries++;
        Results.when(base.command(id, by), thread, outcome -> triggered(order, by, outcome), why -> fail(order, why));
    }

    private void triggered(Order order, VehicleCommand by, CommandOutcome outcome) {
        if (pending.filter(now -> now == order).isEmpty()) {
            return;
        }
        if (outcome.isAccepted()) {
            order.accepted = true;
            order.acceptedMs = nowMs;
            finish(order);
        } else if (outcome.verdict() == CommandVerdict.UNKNOWN_TO_IT
                && !by.equals(VehicleCommand.triggerCamera())) { // an older firmware
            trigger(order, VehicleCommand.triggerCamera());
        } else if (isBusy(outcome) && order.picture.isPresent()) { // taken a little later, as some cameras do
            order.accepted = true;
            finish(order);
        } else if (isBusy(outcome) && order.tries < TRIES) {
            trigger(order, by);
        } else {
            fail(order, outcome.inWords());
        }
    }

    /** Whether it may only be at its last picture still: ArduPilot says that it fails as long as the shutter of that one is held ({@code CAM1_DURATION}). */
    private static boolean isBusy(CommandOutcome outcome) {
        return outcome.verdict() == CommandVerdict.FAILED || outcome.verdict() == CommandVerdict.NOT_NOW;
    }

    /** The autopilot reports a picture, whoever has asked for it; one from before it was asked answers no order. */
    void taken(VehicleEvent.PictureTaken picture) {
        pending.filter(order -> order.asked).ifPresent(order -> {
            order.picture = Optional.of(picture);
            finish(order);
        });
    }

    private void finish(Order order) {
        if (order.accepted && order.picture.isPresent()) {
            VehicleEvent.PictureTaken picture = order.picture.get();
            pending = Optional.empty();
            order.answer.accept(new Ack(order.command.commandId()));
            broadcast.accept(new PanoramaReport(order.command.commandId(), 1, picture.latDeg(), picture.lonDeg()));
        }
    }

    void tick(long atMs) {
        nowMs = atMs;
        pending.filter(order -> order.accepted && atMs - order.acceptedMs > REPORTED_MS)
                .ifPresent(order -> fail(
                        order,
                        "vehicle " + id + " accepts to take a picture, but does not report one within "
                                + REPORTED_MS / 1000 + " s (CAMERA_FEEDBACK)"));
    }

    private void fail(Order order, String why) {
        if (pending.filter(now -> now == order).isPresent()) {
            end(order, missing.isPresent() ? NackReason.NO_CAMERA : NackReason.NOT_ABLE, why);
        }
    }

    private void end(Order order, NackReason reason, String why) {
        pending = Optional.empty();
        order.answer.accept(new Nack(order.command.commandId(), reason, why));
    }
}

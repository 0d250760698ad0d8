package org.sami.mavlink.onboard;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.Semaphore;
import java.util.function.LongSupplier;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.link.LinkEnd;
import org.sami.mavlink.link.MavlinkLink;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.link.ReceivedMessage;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.TextSeverity;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * A boat's link to ground stations: opened, kept open, and spoken on. What comes is handed to the thread that owns the boat; all methods but {@link #report} and
 * {@link #close} are for that thread.
 */
public final class OnboardLink implements AutoCloseable {
    private static final int MOST_SYSTEM = 254; // 255 is the ground station's
    private static final int UNHANDLED = 200; // messages that may wait; more are lost, as on a radio

    private final MavlinkLink link;
    private final OnboardVehicle vehicle;
    private final Semaphore room = new Semaphore(UNHANDLED);
    private final Executor owner;
    private final LongSupplier nowMs;

    /**
     * A link that is not begun yet.
     *
     * @param name of the boat
     * @param system its system id
     * @param capacity how many items its mission may have
     * @param owner runs what it is given on the thread that owns the boat
     * @param nowMs a clock of milliseconds that only goes on
     * @throws IllegalArgumentException if the system id is not 1 to 254
     */
    public OnboardLink(
            String name,
            int system,
            MavlinkAddress address,
            int capacity,
            OnboardHost host,
            Executor owner,
            LongSupplier nowMs) {
        checkSystem(system);
        this.owner = owner;
        this.nowMs = nowMs;
        link = new MavlinkLink(
                address,
                (from, messages) -> messages.forEach(this::received),
                new LinkEnd(system, OnboardVehicle.AUTOPILOT, 0, Optional.empty()),
                kind -> true);
        vehicle = new OnboardVehicle(name, system, capacity, host, link::send);
    }

    /** Refuses what is no system id of a vehicle.
     *
     * @throws IllegalArgumentException if it is not 1 to 254
     */
    public static void checkSystem(int system) {
        if (system < 1 || system > MOST_SYSTEM) {
            throw new IllegalArgumentException("a vehicle's system id is 1 to " + MOST_SYSTEM + ", not " + system);
        }
    }

    /** Begins; returns at once. */
    public void start() {
        link.start();
    }

    private void received(ReceivedMessage message) {
        if (!room.tryAcquire()) {
            return;
        }
        VehicleId station = new VehicleId(message.system(), message.component());
        try {
            owner.execute(() -> {
                room.release();
                vehicle.take(station, message.payload(), nowMs.getAsLong());
            });
        } catch (RejectedExecutionException ended) {
            room.release();
        }
    }

    /** Lets time pass: sends what is due. */
    public void tick(long now) {
        vehicle.tick(now);
    }

    /** Says something to the people at ground stations. */
    public void say(TextSeverity severity, String text) {
        vehicle.say(severity, text);
    }

    /** An item of the mission is reached. */
    public void reached(int item) {
        vehicle.reached(item);
    }

    /** The boat left its fence, came back or has another: stations hear it at once. */
    public void fenceChanged() {
        vehicle.fenceChanged();
    }

    /** Something is measured; of its name the first ten characters are sent. */
    public void measured(String what, double value) {
        vehicle.measured(what, value);
    }

    /** Puts a mission there from aboard; the host is not asked. */
    public void hold(List<MissionItem> mission) {
        vehicle.hold(mission);
    }

    /** How the link is. For any thread. */
    public MavlinkLinkReport report() {
        return link.report();
    }

    /** Closes the link and waits for its threads. Not for the thread that owns the boat. */
    @Override
    public void close() {
        link.close();
    }
}

package org.sami.mavlink.testing;

import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MavSysStatusSensor;
import io.dronefleet.mavlink.common.MissionClearAll;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.ListKeeper;
import org.sami.mavlink.onboard.OnboardLists;
import org.sami.mavlink.vehicle.VehicleId;

/** The fence that a small vehicle holds, and its transfer. Safe for use by several threads. */
public final class SmallVehicleFence {
    private static final int CORNERS = 84;
    private static final int BIT =
            EnumValue.of(MavSysStatusSensor.MAV_SYS_STATUS_GEOFENCE).value();
    private static final VehicleId STATION = new VehicleId(255, 190);

    private final OnboardLists lists;
    private int uploads;
    private int refusedCorner = -1;
    private boolean outside;
    private int type;
    private int kinds;
    private boolean on; // in force
    private double enable; // FENCE_ENABLE

    /** No fence. */
    SmallVehicleFence(Consumer<Object> send) {
        lists = new OnboardLists(CORNERS, 0, new Keeper(), send);
    }

    /** The fence that it holds. */
    public synchronized List<MissionItem> items() {
        return lists.held(HeldKind.FENCE);
    }

    /** Its owner has given it this fence. */
    public synchronized void put(List<MissionItem> items) {
        lists.put(HeldKind.FENCE, items);
    }

    /** How many fences were sent to it. */
    public synchronized int uploads() {
        return uploads;
    }

    /** It refuses a corner of each fence from now on; -1 for none. */
    public synchronized void refuseCorner(int number) {
        refusedCorner = number;
    }

    /** It reports that it is outside of its fence from now on, or no longer. */
    public synchronized void outside(boolean now) {
        outside = now;
    }

    /** Somebody puts it in force, or out of force, by a command or a switch of the radio control; {@code FENCE_ENABLE} stays as it is. */
    public synchronized void switched(boolean now) {
        on = now;
        kinds = type;
    }

    /** Its kinds in force, in bits of {@code FENCE_TYPE}: those that it had when it was switched on last. */
    public synchronized int kinds() {
        return kinds;
    }

    /** Whether it is in force. */
    public synchronized boolean isOn() {
        return on;
    }

    /** Its parameter is so: another value than before switches it. */
    synchronized void set(double value, double newType) {
        type = (int) newType;
        if (Double.compare(enable, value) != 0) {
            enable = value;
            on = value > 0;
            kinds = type;
        }
    }

    /** The bit of a fence that it holds, as it is reported. */
    synchronized int present() {
        return items().isEmpty() ? 0 : BIT;
    }

    /** The same of one that is in force. */
    synchronized int enabled() {
        return on ? present() : 0;
    }

    synchronized boolean isOutside() {
        return outside;
    }

    /**
     * Receives a message.
     *
     * @param bootMs the time since the autopilot started, in ms
     * @return false where it is not about the fence; nothing is done then
     */
    synchronized boolean take(Object message, long bootMs) {
        boolean about = isAboutFence(message);
        if (about) {
            lists.take(STATION, message, bootMs);
        }
        return about;
    }

    /** Repeats and gives up transfers at a time. */
    synchronized void tick(long bootMs) {
        lists.tick(bootMs);
    }

    private static boolean isAboutFence(Object message) {
        Optional<EnumValue<MavMissionType>> type = Optional.empty();
        if (message instanceof MissionRequestList asked) {
            type = Optional.of(asked.missionType());
        } else if (message instanceof MissionRequestInt asked) {
            type = Optional.of(asked.missionType());
        } else if (message instanceof MissionCount count) {
            type = Optional.of(count.missionType());
        } else if (message instanceof MissionItemInt item) {
            type = Optional.of(item.missionType());
        } else if (message instanceof MissionClearAll all) {
            type = Optional.of(all.missionType());
        }
        return type.flatMap(HeldKind::of).filter(HeldKind.FENCE::equals).isPresent();
    }

    /** Accepts every fence but one with the corner that is to be refused. */
    private final class Keeper implements ListKeeper {
        @Override
        public Optional<Refusal> whyNot(HeldKind kind, MissionItem item) {
            return item.number() == refusedCorner ? Optional.of(Refusal.INVALID) : Optional.empty();
        }

        @Override
        public void changed(HeldKind kind, List<MissionItem> items) {
            uploads++;
        }
    }
}

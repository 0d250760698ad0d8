package org.sami.mavlink.testing;

import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequest;
import io.dronefleet.mavlink.common.MissionRequestInt;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;

/** Messages between a base and a vehicle by which a test knows how far both are, for {@link UdpFaultProxy#holdAt}. */
public final class WireMoments {
    private static final int ARM = 400;

    private WireMoments() {}

    /** A base gives a command. */
    public static boolean isCommand(Object message) {
        return message instanceof CommandLong;
    }

    /** A base orders to arm or to disarm. */
    public static boolean isArming(Object message) {
        return message instanceof CommandLong order && order.command().value() == ARM;
    }

    /** The vehicle of a system id asks for an item of a mission that it is to be sent. */
    @SuppressWarnings("deprecation") // ArduPilot still asks by the older message
    public static Predicate<Object> asksForItem(int system) {
        return message -> (message instanceof MissionRequestInt each && each.targetSystem() != system)
                || (message instanceof MissionRequest one && one.targetSystem() != system);
    }

    /** The so many-th item of a mission is sent to the vehicle of a system id. */
    public static Predicate<Object> itemIsSent(int system, int which) {
        AtomicInteger sent = new AtomicInteger();
        return message -> message instanceof MissionItemInt item
                && item.targetSystem() == system
                && sent.incrementAndGet() == which;
    }

    /** The vehicle of a system id says that it has taken a mission. */
    public static Predicate<Object> missionIsTaken(int system) {
        return message -> message instanceof MissionAck ack
                && ack.targetSystem() != system
                && ack.type().entry() == MavMissionResult.MAV_MISSION_ACCEPTED;
    }
}

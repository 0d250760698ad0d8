package org.sami.mavlink.base;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * What each vehicle on a link is asked to send, so that all of it fits: on a slow link everything is asked for less often, by one factor, but for what tells that others have
 * changed the mission. Heartbeats come once a
 * second unasked and are counted; the other direction, texts and lists get what is left over.
 *
 * @param messages what each vehicle is asked for
 * @param bytesPerSecond what the link carries in one direction; empty where it does not matter (networks)
 */
public record MessagePlan(List<AskedMessage> messages, int vehicles, boolean signed, OptionalDouble bytesPerSecond) {
    /** The part of a slow link that reports may fill. */
    public static final double FILLED_PART = 0.7;

    private static final AskedMessage HEARTBEAT = new AskedMessage(0, "HEARTBEAT", 9, 1);
    private static final double BITS = 10; // of a byte on a serial line, with start and stop
    private static final double SLOWEST = 1e4;

    /** Tells that another ground station has changed the mission. */
    private static final AskedMessage MISSION = new AskedMessage(42, "MISSION_CURRENT", 18, 1);

    /** With this period a change is noticed within 2 s. */
    private static final double NOTICED_S = 1.8;

    /** What is asked for where there is room. */
    private static final List<AskedMessage> WANTED = List.of(
            new AskedMessage(33, "GLOBAL_POSITION_INT", 28, 0.25),
            new AskedMessage(1, "SYS_STATUS", 43, 1),
            new AskedMessage(24, "GPS_RAW_INT", 52, 1),
            new AskedMessage(193, "EKF_STATUS_REPORT", 26, 1),
            MISSION,
            new AskedMessage(162, "FENCE_STATUS", 9, 2),
            new AskedMessage(173, "RANGEFINDER", 8, 1),
            new AskedMessage(11038, "WATER_DEPTH", 38, 1),
            new AskedMessage(168, "WIND", 12, 2));

    /** A plan. */
    public MessagePlan {
        messages = List.copyOf(messages);
    }

    /** The plan for so many vehicles that share a link. */
    public static MessagePlan of(MavlinkAddress address, int vehicles, boolean signed) {
        return of(address.speedBaud(), vehicles, signed);
    }

    /**
     * The plan for so many vehicles that share a link of a speed.
     *
     * @param baud empty where it does not matter (networks)
     */
    static MessagePlan of(OptionalInt baud, int vehicles, boolean signed) {
        OptionalDouble carried = carried(baud);
        double each = WANTED.stream()
                .mapToDouble(message -> message.bytesPerSecond(signed))
                .sum();
        double mission = MISSION.bytesPerSecond(signed);
        double free = carried.orElse(Double.POSITIVE_INFINITY) * FILLED_PART / Math.max(1, vehicles)
                - HEARTBEAT.bytesPerSecond(signed);
        double even = factor(each, free);
        double ofMission = Math.min(even, NOTICED_S / MISSION.everyS());
        boolean fits = mission / ofMission < free / 2; // else there would be little but that
        double ofMissionThere = fits ? ofMission : even;
        double ofOthers = fits ? factor(each - mission, free - mission / ofMission) : even;
        return new MessagePlan(
                WANTED.stream()
                        .map(message -> message.slower(message.equals(MISSION) ? ofMissionThere : ofOthers))
                        .toList(),
                vehicles,
                signed,
                carried);
    }

    /** How much less often messages come that would fill more than there is. */
    private static double factor(double wanted, double free) {
        return free <= 0 ? SLOWEST : Math.min(SLOWEST, Math.max(1, wanted / free));
    }

    private static OptionalDouble carried(OptionalInt baud) {
        return baud.isPresent() ? OptionalDouble.of(baud.getAsInt() / BITS) : OptionalDouble.empty();
    }

    /** Whether it is made for so many vehicles and a link of this speed. */
    boolean isFor(OptionalInt baud, int count) {
        return count == vehicles && bytesPerSecond.equals(carried(baud));
    }

    /** What one vehicle sends, its heartbeat included, bytes a second. */
    public double bytesPerVehicle() {
        return HEARTBEAT.bytesPerSecond(signed)
                + messages.stream()
                        .mapToDouble(message -> message.bytesPerSecond(signed))
                        .sum();
    }

    /** The part of the link that all vehicles together fill, 0 to 1 and more; empty where it does not matter. */
    public OptionalDouble filledPart() {
        return bytesPerSecond.isEmpty()
                ? OptionalDouble.empty()
                : OptionalDouble.of(vehicles * bytesPerVehicle() / bytesPerSecond.getAsDouble());
    }

    /** Whether the messages that vehicles send unasked would fill the link, so that vehicles must be asked to stop them. */
    boolean isTight() {
        return bytesPerSecond.isPresent();
    }
}

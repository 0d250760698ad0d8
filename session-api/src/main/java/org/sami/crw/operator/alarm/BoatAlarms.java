package org.sami.crw.operator.alarm;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.BiConsumer;
import org.sami.boat.link.BatteryLevel;
import org.sami.crw.operator.alarm.Alarm.Kind;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.LinkState;

/** Finds the alarms of one boat from its known state. For one thread. */
public final class BoatAlarms {
    private final PoseCheck poses = new PoseCheck();
    private final RangeCheck ranges = new RangeCheck();
    private final DriftCheck drifts = new DriftCheck();
    private final PhoneCheck phones = new PhoneCheck();
    private final FenceCheck fence;

    public BoatAlarms(FenceCheck fence) {
        this.fence = fence;
    }

    public void remove(String boat) {
        poses.remove(boat);
        ranges.remove(boat);
        drifts.remove(boat);
        phones.remove(boat);
        fence.remove(boat);
    }

    /** What a reading of a boat's phone says of alarms: for each kind that it decides on its text, or none where nothing is wrong. */
    public Map<Kind, Optional<String>> measured(String boat, BoatReading reading, long atMillis) {
        return phones.measured(boat, reading, atMillis);
    }

    /** Gives kind and boat of each alarm that has ended because the phone repeats it no longer. */
    public void phonesSilent(long nowMillis, BiConsumer<Kind, String> ended) {
        phones.over(nowMillis).forEach(subject -> ended.accept(subject.kind(), subject.boat()));
    }

    /** What is wrong with a boat that was just seen, for each kind that can be; empty where nothing is. */
    public Map<Kind, Optional<String>> wrong(BoatSnapshot boat, CommandQueueSnapshot queue) {
        Map<Kind, Optional<String>> wrong = new EnumMap<>(Kind.class);
        String id = boat.boat();
        Cause cause = boat.why().cause();
        wrong.put(
                Kind.LINK_LOST,
                when(boat.link() == LinkState.LOST, "The link to " + id + " is lost; its commands wait"));
        wrong.put(Kind.BATTERY_CRITICAL, battery(boat, BatteryLevel.CRITICAL, "critical"));
        wrong.put(Kind.BATTERY_LOW, battery(boat, BatteryLevel.LOW, "low"));
        wrong.put(Kind.RANGE, ranges.of(boat));
        wrong.put(
                Kind.BOAT_CRITICAL,
                when(
                        cause == Cause.STARTED_ANEW || cause == Cause.REFUSES || cause == Cause.BATTERY_EMPTY,
                        boat.why().text()));
        wrong.put(Kind.NO_PROGRESS, when(cause == Cause.NO_PROGRESS, id + " comes no nearer to its next point"));
        wrong.put(Kind.DRIFT, drifts.of(boat));
        Optional<PoseCheck.Doubt> doubt = boat.pose().map(pose -> poses.at(id, pose));
        wrong.put(Kind.POSITION_DOUBTFUL, doubt.flatMap(PoseCheck.Doubt::position));
        wrong.put(Kind.COMPASS_DOUBTFUL, doubt.flatMap(PoseCheck.Doubt::heading));
        wrong.put(Kind.FENCE, boat.pose().flatMap(pose -> fence.position(id, pose.position(), queue)));
        wrong.put(Kind.FENCE_AHEAD, fence.path(id, boat.pose().map(BoatPose::position), queue));
        return wrong;
    }

    private static Optional<String> battery(BoatSnapshot boat, BatteryLevel level, String word) {
        return boat.battery()
                .filter(battery -> battery.level() == level)
                .map(battery -> "The battery of " + boat.boat() + " is " + word
                        + (UnknownCharge.why(boat).isPresent()
                                ? " by its autopilot's own limits"
                                : charge(boat, battery)));
    }

    private static String charge(BoatSnapshot boat, BatteryState battery) {
        return ": " + Math.round(battery.percent()) + " %"
                + RangeCheck.rangeM(boat)
                        .map(rangeM -> ", for about " + Math.round(rangeM / 100) * 100 + " m")
                        .orElse("");
    }

    /**
     * The alarm about the age of a boat's pose.
     *
     * @param sampledEveryMillis interval by which the pose may be older than the base's last report
     */
    public static Optional<String> stale(BoatSnapshot boat, long nowMillis, long sampledEveryMillis) {
        OptionalLong age = boat.poseAgeMillis(nowMillis);
        return when(
                boat.link() == LinkState.LINKED
                        && age.orElse(0) > AlarmLimits.POSITION_STALE_AFTER_MS + sampledEveryMillis,
                boat.boat() + " has not said where it is for " + age.orElse(0) / 1000 + " s, though its link stands");
    }

    private static Optional<String> when(boolean is, String text) {
        return is ? Optional.of(text) : Optional.empty();
    }
}

package org.sami.crw.operator.boat;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.sami.boat.link.BoatMode;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.Drift;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.status.StopLatch;
import org.sami.spn.value.GeoPoint;

/**
 * One boat at a moment. Times are milliseconds on the session's clock.
 *
 * @param pose its last reported pose; empty before the first
 * @param poseAtMillis time of that report; 0 before the first
 * @param battery its last reported battery state; empty before the first
 * @param mode the mode of its server; empty before the first report
 * @param heardAtMillis time of the last frame; empty before the first
 * @param commander who commands it
 * @param command the command whose turn it is
 * @param visited number of visited points of that command's path
 * @param points number of points of that path; 0 for a command without one
 * @param why why it moves or does not
 * @param drift its drift while it does not drive; empty for one that drives, or without reports
 * @param stop whether it is stopped until a release
 * @param wayHome its expected way home, from its last position with the turns between, while it returns by itself; otherwise empty
 * @param settings the settings that it last reported to be in force; empty before the first report
 * @param flies whether it does; false before its first report
 */
public record BoatSnapshot(
        String boat,
        LinkState link,
        OptionalLong heardAtMillis,
        Optional<BoatPose> pose,
        long poseAtMillis,
        Optional<BatteryState> battery,
        Optional<BoatMode> mode,
        Commander commander,
        Optional<BoatCommand> command,
        int visited,
        int points,
        BoatExplanation why,
        Optional<Drift> drift,
        StopLatch stop,
        List<GeoPoint> wayHome,
        Optional<BoatTuning> settings,
        boolean flies) {

    /** Who commands a boat. */
    public enum Commander {
        /** This base, for its missions. */
        THIS_BASE,
        /** A person at this base, by hand; what missions want waits. */
        BY_HAND,
        /** Another client, or nobody; this base watches. */
        SOMEBODY_ELSE,
        /** It has not said so yet. */
        UNKNOWN
    }

    /** A boat that neither drifts nor is stopped, and has reported no settings. */
    public BoatSnapshot(
            String boat,
            LinkState link,
            OptionalLong heardAtMillis,
            Optional<BoatPose> pose,
            long poseAtMillis,
            Optional<BatteryState> battery,
            Optional<BoatMode> mode,
            Commander commander,
            Optional<BoatCommand> command,
            int visited,
            int points,
            BoatExplanation why,
            List<GeoPoint> wayHome) {
        this(
                boat,
                link,
                heardAtMillis,
                pose,
                poseAtMillis,
                battery,
                mode,
                commander,
                command,
                visited,
                points,
                why,
                Optional.empty(),
                StopLatch.NONE,
                wayHome,
                Optional.empty());
    }

    /** One that does not fly. */
    public BoatSnapshot(
            String boat,
            LinkState link,
            OptionalLong heardAtMillis,
            Optional<BoatPose> pose,
            long poseAtMillis,
            Optional<BatteryState> battery,
            Optional<BoatMode> mode,
            Commander commander,
            Optional<BoatCommand> command,
            int visited,
            int points,
            BoatExplanation why,
            Optional<Drift> drift,
            StopLatch stop,
            List<GeoPoint> wayHome,
            Optional<BoatTuning> settings) {
        this(
                boat,
                link,
                heardAtMillis,
                pose,
                poseAtMillis,
                battery,
                mode,
                commander,
                command,
                visited,
                points,
                why,
                drift,
                stop,
                wayHome,
                settings,
                false);
    }

    /** The same of one that flies, or does not. */
    public BoatSnapshot flying(boolean does) {
        return new BoatSnapshot(
                boat,
                link,
                heardAtMillis,
                pose,
                poseAtMillis,
                battery,
                mode,
                commander,
                command,
                visited,
                points,
                why,
                drift,
                stop,
                wayHome,
                settings,
                does);
    }

    /** A boat of which nothing has been heard. */
    static BoatSnapshot unknown(String boat, BoatExplanation why) {
        return new BoatSnapshot(
                boat,
                LinkState.CONNECTING,
                OptionalLong.empty(),
                Optional.empty(),
                0,
                Optional.empty(),
                Optional.empty(),
                Commander.UNKNOWN,
                Optional.empty(),
                0,
                0,
                why,
                List.of());
    }

    public BoatSnapshot {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(link, "link");
        Objects.requireNonNull(heardAtMillis, "heardAtMillis");
        Objects.requireNonNull(pose, "pose");
        Objects.requireNonNull(battery, "battery");
        Objects.requireNonNull(mode, "mode");
        Objects.requireNonNull(commander, "commander");
        Objects.requireNonNull(command, "command");
        Objects.requireNonNull(why, "why");
        Objects.requireNonNull(drift, "drift");
        Objects.requireNonNull(stop, "stop");
        wayHome = List.copyOf(wayHome);
        Objects.requireNonNull(settings, "settings");
    }

    /**
     * What it is, as it has reported itself; before its first report what a session is for.
     *
     * @param robots what the session's plans command; where those are of several kinds, one that has not reported yet is taken for a boat
     */
    public RobotKind kind(RobotKind robots) {
        return pose.isEmpty() ? robots.of(flies) : RobotKind.ROBOT.of(flies);
    }

    /**
     * Why plans cannot command it, as {@code is a boat, and this session flies copters}; empty where they can, and before its first report.
     *
     * @param robots what the session's plans command
     */
    public Optional<String> unfit(RobotKind robots) {
        return pose.isEmpty() ? Optional.empty() : robots.unfit(flies);
    }

    /** How old the pose is, in ms; empty where there is none. */
    public OptionalLong poseAgeMillis(long nowMillis) {
        return pose.isEmpty() ? OptionalLong.empty() : OptionalLong.of(Math.max(0, nowMillis - poseAtMillis));
    }

    /**
     * Speed over ground in m/s: of the drift for a boat that does not drive, otherwise as reported; negative astern. Empty before the first position.
     */
    public OptionalDouble speedMps() {
        OptionalDouble carried = drift.filter(Drift::isMoving).stream()
                .mapToDouble(Drift::speedMps)
                .findFirst();
        return carried.isPresent()
                ? carried
                : pose.stream().mapToDouble(BoatPose::speedMps).findFirst();
    }

    /** The same in words: {@code 1.4 m/s}, or {@code 0.25 m/s} where it is carried; empty text before it has said where it is. */
    public String speedWords() {
        if (speedMps().isEmpty()) {
            return "";
        }
        double mps = speedMps().getAsDouble();
        return drift.filter(Drift::isMoving).isPresent()
                ? String.format(Locale.ROOT, "%.2f m/s", mps)
                : String.format(Locale.ROOT, "%.1f m/s", Math.round(mps * 10) / 10.0);
    }

    /** For how long nothing has come over the link, in ms; empty where nothing ever has. */
    public OptionalLong linkAgeMillis(long nowMillis) {
        return heardAtMillis.isEmpty()
                ? heardAtMillis
                : OptionalLong.of(Math.max(0, nowMillis - heardAtMillis.getAsLong()));
    }
}

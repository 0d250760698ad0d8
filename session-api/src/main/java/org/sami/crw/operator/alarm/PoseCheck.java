package org.sami.crw.operator.alarm;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.LocalPlane;

/**
 * Checks a boat's reported positions and headings one after the other. A position that jumps, or stands still while the boat moves, is doubtful; so
 * is a heading away from the boat's motion (the compass failures of thesis 6.3.3). For one thread.
 */
final class PoseCheck {
    /** No boat of the fleet is faster than this over ground. */
    private static final double FASTEST_MPS = AlarmLimits.FASTEST_MPS;

    /** A receiver's noise. */
    private static final double NOISE_M = 10;

    /** From this speed on a boat moves for sure. */
    private static final double MOVING_MPS = 0.5;

    private static final long FROZEN_AFTER_MS = AlarmLimits.FROZEN_AFTER_MS;
    private static final long TRUSTED_AGAIN_AFTER_MS = 10_000;

    /** A course is measured over this way: less is noise. */
    private static final double LEG_M = 3;

    /** Wind and current turn a boat's course from its heading by less than this. */
    private static final double WRONG_COURSE_RAD = Math.toRadians(AlarmLimits.WRONG_COURSE_DEG);

    private static final int WRONG_LEGS = 3;

    private final Map<String, Followed> boats = new HashMap<>();

    private static final class Followed {
        private BoatPose last;
        private BoatPose legStart;
        private double legEast;
        private double legNorth;
        private long stillSinceMs;
        private long jumpedAtMs = Long.MIN_VALUE / 2;
        private double jumpM;
        private int wrongLegs;

        Followed(BoatPose first) {
            last = first;
            legStart = first;
            stillSinceMs = first.boatTimeMs();
        }
    }

    /**
     * What is doubtful about a boat's pose.
     *
     * @param position in words; empty where nothing is
     * @param heading likewise
     */
    record Doubt(Optional<String> position, Optional<String> heading) {
        static final Doubt NONE = new Doubt(Optional.empty(), Optional.empty());
    }

    /** A boat has said where it is. */
    Doubt at(String boat, BoatPose pose) {
        Followed followed = boats.computeIfAbsent(boat, id -> new Followed(pose));
        long sinceMs = pose.boatTimeMs() - followed.last.boatTimeMs();
        if (sinceMs < 0) { // the boat's server restarted, and its clock with it
            boats.put(boat, new Followed(pose));
            return Doubt.NONE;
        }
        if (sinceMs > 0) {
            follow(followed, pose, sinceMs);
        }
        return new Doubt(position(boat, followed), heading(boat, followed));
    }

    void remove(String boat) {
        boats.remove(boat);
    }

    private static void follow(Followed followed, BoatPose pose, long sinceMs) {
        double movedM = Geodesy.distanceM(followed.last.position(), pose.position());
        if (movedM > FASTEST_MPS * sinceMs / 1000 + NOISE_M) {
            followed.jumpedAtMs = pose.boatTimeMs();
            followed.jumpM = movedM;
            startLeg(followed, pose);
        }
        if (movedM > 0 || Math.abs(pose.speedMps()) < MOVING_MPS) {
            followed.stillSinceMs = pose.boatTimeMs();
        }
        if (Math.abs(pose.speedMps()) < MOVING_MPS) {
            startLeg(followed, pose); // who does not drive is carried in any direction
        } else {
            double ahead = Math.signum(pose.speedMps());
            followed.legEast += ahead * Math.sin(pose.headingRad());
            followed.legNorth += ahead * Math.cos(pose.headingRad());
            endLeg(followed, pose);
        }
        followed.last = pose;
    }

    private static void startLeg(Followed followed, BoatPose pose) {
        followed.legStart = pose;
        followed.legEast = 0;
        followed.legNorth = 0;
    }

    /** Compares the course of a leg with the mean of its headings. */
    private static void endLeg(Followed followed, BoatPose pose) {
        LocalPlane plane = new LocalPlane(followed.legStart.position());
        double east = plane.x(pose.position());
        double north = plane.y(pose.position());
        if (Math.hypot(east, north) >= LEG_M) {
            double course = Math.atan2(east, north);
            double heading = Math.atan2(followed.legEast, followed.legNorth);
            boolean wrong = Math.abs(Math.IEEEremainder(course - heading, 2 * Math.PI)) > WRONG_COURSE_RAD;
            followed.wrongLegs = wrong ? followed.wrongLegs + 1 : 0;
            startLeg(followed, pose);
        }
    }

    private static Optional<String> position(String boat, Followed followed) {
        long now = followed.last.boatTimeMs();
        if (now - followed.jumpedAtMs < TRUSTED_AGAIN_AFTER_MS) {
            return Optional.of(String.format(
                    Locale.ROOT, "The position of %s is doubtful: it jumped by %.0f m", boat, followed.jumpM));
        }
        return now - followed.stillSinceMs >= FROZEN_AFTER_MS
                ? Optional.of("The position of " + boat + " is doubtful: it stays the same while the boat moves")
                : Optional.empty();
    }

    private static Optional<String> heading(String boat, Followed followed) {
        return followed.wrongLegs >= WRONG_LEGS
                ? Optional.of("The compass of " + boat + " is doubtful: the boat does not go where it heads")
                : Optional.empty();
    }
}

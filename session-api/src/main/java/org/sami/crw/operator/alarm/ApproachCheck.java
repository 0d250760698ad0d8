package org.sami.crw.operator.alarm;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.LocalPlane;

/**
 * Whether boats come too near to each other, by their closest point of approach if both keep course and speed. For one thread.
 *
 * <p>Robots that fly are as high as they report, above the place of their take-off, and climb or descend as their reports differ; all others are at
 * height 0. One that flies over another keeps as far from it as their heights differ.
 */
public final class ApproachCheck {
    private static final double MOVING_MPS = 0.3;
    private static final long PERIOD_MILLIS = 1000;

    private final Map<String, Moving> boats = new LinkedHashMap<>();
    private final Map<String, Long> lookedAtMillis = new HashMap<>();
    private final Map<String, Set<String>> near = new HashMap<>(); // who comes too near to whom, both ways
    private final ClimbRate climbs = new ClimbRate();
    private Optional<LocalPlane> plane = Optional.empty();

    private record Moving(
            double x, double y, double z, double east, double north, double up, double reachM, boolean stands) {
        static Moving of(LocalPlane plane, BoatPose pose, double upMps) {
            double east = pose.speedMps() * Math.sin(pose.headingRad());
            double north = pose.speedMps() * Math.cos(pose.headingRad());
            return new Moving(
                    plane.x(pose.position()),
                    plane.y(pose.position()),
                    pose.position().altM(),
                    east,
                    north,
                    upMps,
                    AlarmLimits.APPROACH_M / 2 + AlarmLimits.APPROACH_WITHIN_S * Math.abs(pose.speedMps()),
                    Math.abs(pose.speedMps()) < MOVING_MPS && Math.abs(upMps) < MOVING_MPS);
        }

        /** Whether the two are too far apart to come near in time, wherever they go: so are most of a large fleet. */
        boolean isFarFrom(Moving other) {
            double mostM = reachM + other.reachM;
            return Math.abs(other.x - x) > mostM || Math.abs(other.y - y) > mostM;
        }
    }

    /**
     * Takes a report of a boat's position and motion. Returns each boat that it approaches too closely, with a sentence, and those that it no longer
     * approaches, without one. A boat is not checked again shortly after its last check.
     */
    public Map<String, Optional<String>> at(String boat, BoatPose pose, long atMillis) {
        LocalPlane at = plane.orElseGet(() -> new LocalPlane(pose.position()));
        plane = Optional.of(at);
        Moving one = Moving.of(at, pose, climbs.at(boat, pose));
        boats.put(boat, one);
        if (atMillis - lookedAtMillis.getOrDefault(boat, Long.MIN_VALUE / 2) < PERIOD_MILLIS) {
            return Map.of();
        }
        lookedAtMillis.put(boat, atMillis);
        Map<String, Optional<String>> found = new LinkedHashMap<>();
        Set<String> neighbours = neighbours(boat);
        boats.forEach((other, two) -> {
            if (one.isFarFrom(two) && neighbours.isEmpty()) {
                return;
            }
            if (!other.equals(boat)) {
                Optional<String> words = approach(boat, one, other, two);
                if (words.isPresent()) {
                    neighbours.add(other);
                    neighbours(other).add(boat);
                    found.put(other, words);
                } else if (neighbours.remove(other)) {
                    neighbours(other).remove(boat);
                    found.put(other, words);
                }
            }
        });
        return found;
    }

    public void remove(String boat) {
        boats.remove(boat);
        lookedAtMillis.remove(boat);
        climbs.remove(boat);
        near.remove(boat);
        near.values().forEach(others -> others.remove(boat));
    }

    private Set<String> neighbours(String boat) {
        return near.computeIfAbsent(boat, id -> new HashSet<>());
    }

    private static Optional<String> approach(String boat, Moving one, String other, Moving two) {
        if (one.stands() && two.stands()) {
            return Optional.empty(); // boats that lie at the quay
        }
        return Meeting.of(one, two)
                .map(meeting -> String.format(
                        Locale.ROOT,
                        "%s and %s come within %.0f m of each other in %.0f s",
                        boat.compareTo(other) < 0 ? boat : other, // whoever is looked at
                        boat.compareTo(other) < 0 ? other : boat,
                        meeting.distanceM(),
                        meeting.inS()));
    }

    /** Where two come too near to each other in time. */
    private record Meeting(double distanceM, double inS) {
        static Optional<Meeting> of(Moving one, Moving two) {
            double x = two.x() - one.x();
            double y = two.y() - one.y();
            double z = two.z() - one.z();
            double east = two.east() - one.east();
            double north = two.north() - one.north();
            double up = two.up() - one.up();
            double overGroundS = closestS(x * east + y * north, east * east + north * north);
            // a rate of climb is rough: it shows that heights meet, not that those which are equal now will part
            double apartM = leastApartM(z, z + overGroundS * up);
            Optional<Meeting> overGround = Optional.of(
                    new Meeting(length(x + overGroundS * east, y + overGroundS * north, apartM), overGroundS));
            double inSpaceS = closestS(x * east + y * north + z * up, east * east + north * north + up * up);
            Meeting inSpace = new Meeting( // of one that descends onto another that hovers
                    length(x + inSpaceS * east, y + inSpaceS * north, z + inSpaceS * up), inSpaceS);
            return overGround
                    .filter(Meeting::isNear)
                    .or(() -> Optional.of(inSpace).filter(Meeting::isNear));
        }

        /** They do not part, there is no time, and they come near. */
        private boolean isNear() {
            return inS >= 0 && inS <= AlarmLimits.APPROACH_WITHIN_S && distanceM < AlarmLimits.APPROACH_M;
        }

        private static double closestS(double product, double squared) {
            return squared == 0 ? 0 : -product / squared;
        }

        private static double leastApartM(double beforeM, double afterM) {
            return beforeM * afterM <= 0 ? 0 : Math.min(Math.abs(beforeM), Math.abs(afterM));
        }

        private static double length(double x, double y, double z) {
            return Math.sqrt(x * x + y * y + z * z);
        }
    }
}

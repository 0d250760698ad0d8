package org.sami.boat.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.mavlink.mission.MissionItem;

/** Reads the items that ground stations send as a fence, and says what is wrong with them. */
final class StationFenceItems {
    /** How many items a fence may have. */
    static final int MOST = 500;

    private static final int RETURN_POINT = 5000;
    private static final int POLYGON_INCLUSION = 5001;
    private static final int POLYGON_EXCLUSION = 5002;
    private static final int CIRCLE_INCLUSION = 5003;
    private static final int CIRCLE_EXCLUSION = 5004;
    private static final int FEWEST_CORNERS = 3;
    private static final double SMALLEST_M2 = 1;
    private static final double MOST_LAT_DEG = 85; // the poles are out of reach of a boat's maps

    private StationFenceItems() {}

    /** Whether a boat has the command of an item. */
    static boolean isKnown(MissionItem item) {
        return item.command() >= RETURN_POINT && item.command() <= CIRCLE_EXCLUSION;
    }

    /** Why a boat cannot keep to an item, in words; empty where it can. */
    static Optional<String> whyNot(MissionItem item) {
        String words = "fence item " + item.number();
        if (!isKnown(item)) {
            return Optional.of(words + ": a boat of SAMI has no " + item.commandName());
        } else if (item.latDeg() == 0 && item.lonDeg() == 0) {
            return Optional.of(words + " is at 0, 0");
        } else if (Math.abs(item.latDeg()) > MOST_LAT_DEG) {
            return Optional.of(words + " is at " + item.latDeg() + " degrees north, too near to a pole");
        } else if (isCircle(item)) {
            return item.param1() > 0 && !Double.isInfinite(item.param1())
                    ? Optional.empty()
                    : Optional.of(words + " is a circle with the radius " + item.param1());
        } else if (isCorner(item)) {
            double corners = item.param1();
            return corners >= FEWEST_CORNERS && corners <= MOST && corners == Math.rint(corners)
                    ? Optional.empty()
                    : Optional.of(words + " is of a polygon of " + plain(corners) + " corners");
        }
        return Optional.empty();
    }

    private static String plain(double number) {
        return number == Math.rint(number) ? Long.toString((long) number) : Double.toString(number);
    }

    private static boolean isCircle(MissionItem item) {
        return item.command() == CIRCLE_INCLUSION || item.command() == CIRCLE_EXCLUSION;
    }

    private static boolean isCorner(MissionItem item) {
        return item.command() == POLYGON_INCLUSION || item.command() == POLYGON_EXCLUSION;
    }

    /** Why a list of items that are each right is no fence, in words; empty where it is one. */
    static Optional<String> whyNotWhole(List<MissionItem> items) {
        for (int i = 0; i < items.size(); ) {
            MissionItem item = items.get(i);
            int corners = isCorner(item) ? (int) item.param1() : 1;
            List<MissionItem> part = items.subList(i, Math.min(items.size(), i + corners));
            if (isCorner(item)) {
                String words = "fence items " + i + " to " + (i + corners - 1);
                long same = part.stream().filter(other -> isOfSame(item, other)).count();
                if (same < corners) {
                    return Optional.of(
                            words + " should be one polygon of " + corners + " corners, and " + same + " are");
                }
                FencePolygon polygon = polygon(part);
                if (polygon.crossesItself()) {
                    return Optional.of(words + ": edges of the polygon cross");
                } else if (polygon.areaM2() < SMALLEST_M2) {
                    return Optional.of(words + ": the polygon has no area");
                }
            }
            i += corners;
        }
        return Optional.empty();
    }

    private static boolean isOfSame(MissionItem one, MissionItem other) {
        return one.command() == other.command() && one.param1() == other.param1() && group(one) == group(other);
    }

    private static FencePolygon polygon(List<MissionItem> corners) {
        return new FencePolygon(
                corners.stream().map(StationFenceItems::position).toList());
    }

    private static Position position(MissionItem item) {
        return new Position(item.latDeg(), item.lonDeg());
    }

    private static int group(MissionItem item) {
        return (int) item.param2(); // 0 where it is not a number
    }

    /** Whether it names a place to return to from outside, which boats do not use. */
    static boolean hasReturnPoint(List<MissionItem> items) {
        return items.stream().anyMatch(item -> item.command() == RETURN_POINT);
    }

    /** The fence that a list is of which nothing is wrong. */
    static StationFence fence(List<MissionItem> items) {
        List<StationFence.Zone> zones = new ArrayList<>();
        for (int i = 0; i < items.size(); ) {
            MissionItem item = items.get(i);
            if (isCircle(item)) {
                FenceCircle circle = new FenceCircle(position(item), item.param1());
                zones.add(new StationFence.Zone(circle, item.command() == CIRCLE_INCLUSION, group(item)));
            } else if (isCorner(item)) {
                FencePolygon polygon = polygon(items.subList(i, i + (int) item.param1()));
                zones.add(new StationFence.Zone(polygon, item.command() == POLYGON_INCLUSION, group(item)));
            }
            i += isCorner(item) ? (int) item.param1() : 1;
        }
        return new StationFence(zones);
    }
}

package org.sami.crw.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.mavlink.mission.MissionItem;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * The area in which boats may go as the fence of an autopilot: each polygon as its corners, one item each, with their number. Holes of the area to stay in are
 * polygons to stay out of; holes of no-go areas are closed.
 *
 * <p>Source: MAVLink's items 5001 (corner of a polygon to stay in) and 5002 (corner of one to stay out of).
 */
final class FenceItems {
    private static final int STAY_IN = 5001;
    private static final int KEEP_OUT = 5002;
    private static final int GLOBAL = 0; // the frame

    private FenceItems() {}

    /** The items; none where boats may go everywhere. */
    static List<MissionItem> of(Optional<GeoArea> within, List<GeoArea> avoid) {
        List<MissionItem> items = new ArrayList<>();
        within.ifPresent(area -> {
            add(area.outline(), STAY_IN, items);
            area.holes().forEach(hole -> add(hole, KEEP_OUT, items));
        });
        avoid.forEach(area -> add(area.outline(), KEEP_OUT, items));
        return List.copyOf(items);
    }

    private static void add(List<GeoPoint> corners, int command, List<MissionItem> items) {
        for (GeoPoint corner : corners) {
            items.add(new MissionItem(
                    items.size(), command, GLOBAL, corner.latDeg(), corner.lonDeg(), 0, corners.size(), 0, 0, 0));
        }
    }

    /** Whether a fence that a vehicle holds is this one. */
    static boolean isHeld(List<MissionItem> items, List<MissionItem> held) {
        if (held.size() != items.size()) {
            return false;
        }
        for (int i = 0; i < items.size(); i++) {
            if (!items.get(i).isSameAs(held.get(i))) {
                return false;
            }
        }
        return true;
    }

    /** The items as one line, by which a fence is recognized; equal for those that a vehicle holds and those that it was sent. */
    static String text(List<MissionItem> items) {
        return items.stream()
                .map(item -> item.command() + " " + item.latDeg() + " " + item.lonDeg() + " " + item.param1())
                .collect(Collectors.joining("; "));
    }
}

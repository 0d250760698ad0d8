package org.sami.boat.mavlink;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.sami.mavlink.mission.MissionItem;

/** Items of fences about a place, whose numbers are set when they are put into a list. */
final class FencePart {
    static final int RETURN_POINT = 5000;
    static final int INCLUSION = 5001;
    static final int EXCLUSION = 5002;
    static final int CIRCLE_INCLUSION = 5003;
    static final int CIRCLE_EXCLUSION = 5004;

    private FencePart() {}

    static MissionItem item(int command, double latDeg, double lonDeg, double param1, double group) {
        return new MissionItem(0, command, 0, latDeg, lonDeg, 0, param1, group, 0, 0);
    }

    /** A square that is twice {@code halfDeg} wide and high. */
    static List<MissionItem> square(int command, double latDeg, double lonDeg, double halfDeg) {
        return polygon(command, new double[][] {
            {latDeg - halfDeg, lonDeg - halfDeg},
            {latDeg + halfDeg, lonDeg - halfDeg},
            {latDeg + halfDeg, lonDeg + halfDeg},
            {latDeg - halfDeg, lonDeg + halfDeg}
        });
    }

    static List<MissionItem> polygon(int command, double[][] corners) {
        return Arrays.stream(corners)
                .map(at -> item(command, at[0], at[1], corners.length, 0))
                .toList();
    }

    static List<MissionItem> circle(int command, double latDeg, double lonDeg, double radiusM) {
        return List.of(item(command, latDeg, lonDeg, radiusM, 0));
    }

    /** A fence of several parts. */
    @SafeVarargs
    static List<MissionItem> list(List<MissionItem>... parts) {
        List<MissionItem> all = new ArrayList<>();
        for (List<MissionItem> part : parts) {
            part.forEach(item -> all.add(item.at(all.size())));
        }
        return all;
    }
}

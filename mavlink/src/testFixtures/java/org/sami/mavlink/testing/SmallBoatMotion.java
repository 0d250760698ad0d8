package org.sami.mavlink.testing;

import io.dronefleet.mavlink.common.MissionItemInt;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Where a small boat is and goes, in a plane. For one thread at a time. */
final class SmallBoatMotion {
    static final int MANUAL = 0;
    static final int HOLD = 4;
    static final int AUTO = 10;
    static final int GUIDED = 15;

    private static final double METRES = 0.0111319; // of a ten millionth of a degree of latitude
    private static final double FULL_SPEED_MPS = 3;
    private static final double FULL_STICK = 1000;
    private static final double REACHED_M = 1;

    private final double times;
    private final double narrower; // a degree of longitude
    private double lat; // ten millionths of degrees
    private double lon;
    private double speedMps = 1;
    private double targetLat;
    private double targetLon;
    private Optional<double[]> course = Optional.empty(); // heading in radians and speed in m/s, in place of a target
    private double stick;
    private double turn;
    private double movedM;
    private final List<double[]> track = new ArrayList<>(); // where it was after each move, as lat and lon

    SmallBoatMotion(double latDeg, double lonDeg, double times) {
        this.times = times;
        lat = latDeg * 1e7;
        lon = lonDeg * 1e7;
        narrower = Math.cos(Math.toRadians(latDeg));
    }

    int lat() {
        return (int) Math.round(lat);
    }

    int lon() {
        return (int) Math.round(lon);
    }

    double speed() {
        return speedMps;
    }

    void speed(double mps) {
        speedMps = mps;
    }

    double movedM() {
        return movedM;
    }

    void goTo(int toLat, int toLon) {
        targetLat = toLat;
        targetLon = toLon;
        course = Optional.empty();
    }

    void steer(double headingRad, double mps) {
        course = Optional.of(new double[] {headingRad, mps});
    }

    /** It has no course any longer. */
    void forgetCourse() {
        course = Optional.empty();
    }

    void sticks(double ahead, double right) {
        stick = ahead;
        turn = right;
    }

    double metresTo(double latDeg, double lonDeg) {
        return metres(latDeg * 1e7, lonDeg * 1e7);
    }

    /** How near it ever came to a place, in metres. */
    double nearestM(double latDeg, double lonDeg) {
        return track.stream()
                .mapToDouble(
                        at -> Math.hypot((latDeg * 1e7 - at[0]) * METRES, (lonDeg * 1e7 - at[1]) * METRES * narrower))
                .min()
                .orElse(Double.MAX_VALUE);
    }

    private double metres(double toLat, double toLon) {
        return Math.hypot((toLat - lat) * METRES, (toLon - lon) * METRES * narrower);
    }

    /** Moves for a time. The items of its mission that it has reached. */
    List<Integer> step(int mode, SmallBoatMission mission, double seconds) {
        double way = speedMps * times * seconds;
        if (mode == GUIDED && course.isPresent()) {
            double metres = course.get()[1] * times * seconds;
            move(metres * Math.cos(course.get()[0]), metres * Math.sin(course.get()[0]));
        } else if (mode == GUIDED) {
            towards(targetLat, targetLon, way);
        } else if (mode == AUTO) {
            return along(mission, way);
        } else if (mode == MANUAL) {
            double metres = stick / FULL_STICK * FULL_SPEED_MPS * times * seconds;
            move(metres * Math.cos(turn / FULL_STICK), metres * Math.sin(turn / FULL_STICK));
        }
        return List.of();
    }

    private List<Integer> along(SmallBoatMission mission, double way) {
        List<Integer> reached = new ArrayList<>();
        double until = movedM + way;
        Optional<MissionItemInt> place = mission.place(this);
        while (place.isPresent() && towards(place.get().x(), place.get().y(), until - movedM)) {
            Optional<Integer> item = mission.arrived();
            item.ifPresent(reached::add);
            place = item.flatMap(more -> mission.place(this));
        }
        return reached;
    }

    /** Goes towards a place by so many metres at most. Whether it is there. */
    boolean comesTo(double toLat, double toLon, double way) {
        return towards(toLat, toLon, way);
    }

    private boolean towards(double toLat, double toLon, double way) {
        double left = metres(toLat, toLon);
        if (left > REACHED_M) {
            double part = Math.min(1, way / left);
            move((toLat - lat) * METRES * part, (toLon - lon) * METRES * narrower * part);
        }
        return metres(toLat, toLon) <= REACHED_M;
    }

    private void move(double northM, double eastM) {
        lat += northM / METRES;
        lon += eastM / (METRES * narrower);
        movedM += Math.hypot(northM, eastM);
        track.add(new double[] {lat, lon});
    }
}

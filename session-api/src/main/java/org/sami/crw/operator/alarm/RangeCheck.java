package org.sami.crw.operator.alarm;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.BoatPerformance;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.reach.Charge;
import org.sami.spn.value.GeoPoint;

/** Whether what is left of a boat's charge takes it to the end of its path. For one thread. */
final class RangeCheck {
    private final Map<String, Way> ways = new HashMap<>();

    /** How far it is from each point of a command's path to its end, in metres. */
    private static final class Way {
        private final String command;
        private final double[] leftM;

        Way(FollowPath path) {
            List<GeoPoint> points = path.points();
            command = path.commandId();
            leftM = new double[points.size()];
            for (int i = points.size() - 2; i >= 0; i--) {
                leftM[i] = leftM[i + 1] + Geodesy.distanceM(points.get(i), points.get(i + 1));
            }
        }
    }

    /** How far the charge of a boat takes it, in metres; empty where it has not said, as for an aircraft, which pays for time and not for its way. */
    static Optional<Double> rangeM(BoatSnapshot boat) {
        BoatPerformance performance =
                boat.settings().map(BoatTuning::performance).orElse(BoatPerformance.UNKNOWN);
        boolean paysForTime = boat.flies() && !performance.metresPerPercent().isPresent();
        return boat.battery()
                .filter(battery -> !paysForTime)
                .map(battery -> boat.command().orElse(null) instanceof FollowPath path
                                && path.speedMps().isPresent()
                        ? battery.charge(performance, path.speedMps().getAsDouble())
                        : battery.charge(performance))
                .map(Charge::meanM);
    }

    void remove(String boat) {
        ways.remove(boat);
    }

    /** What is wrong with a boat's range; empty where nothing is, or where it is not known. */
    Optional<String> of(BoatSnapshot boat) {
        Optional<Double> rangeM = rangeM(boat);
        if (!(boat.command().orElse(null) instanceof FollowPath path)
                || boat.pose().isEmpty()
                || rangeM.isEmpty()
                || boat.visited() >= path.points().size()) {
            ways.remove(boat.boat());
            return Optional.empty();
        }
        Way way = ways.get(boat.boat());
        if (way == null || !way.command.equals(path.commandId())) {
            way = new Way(path);
            ways.put(boat.boat(), way);
        }
        GeoPoint next = path.points().get(boat.visited());
        double leftM =
                way.leftM[boat.visited()] + Geodesy.distanceM(boat.pose().get().position(), next);
        return leftM <= rangeM.get()
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "%s has about %.0f m to go, and its charge lasts for about %.0f m",
                        boat.boat(),
                        leftM,
                        rangeM.get()));
    }
}

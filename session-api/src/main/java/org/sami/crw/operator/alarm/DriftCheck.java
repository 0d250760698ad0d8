package org.sami.crw.operator.alarm;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.status.Drift;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.service.Geodesy;

/** Whether a boat that rests, or is to keep its place, has been carried out of its circle. For one thread. */
final class DriftCheck {
    /** A boat that nobody commands is left alone within this of where it was left, in metres. */
    static final double IDLE_M = AlarmLimits.DRIFT_WITHOUT_COMMAND_M;

    /** A boat on its station goes back from the edge by itself, and makes room for others: only what is farther out, and for long, is carried away. */
    private static final double OUTSIDE_STATION_M = AlarmLimits.DRIFT_OUTSIDE_STATION_M;

    private static final long OUT_FOR_MILLIS = AlarmLimits.DRIFT_AFTER_MS;

    private final Map<String, Station> stations = new HashMap<>();

    private static final class Station {
        private final String command;
        private boolean reached;
        private long outSinceMillis = Long.MAX_VALUE;

        Station(String command) {
            this.command = command;
        }
    }

    void remove(String boat) {
        stations.remove(boat);
    }

    /** What is wrong, in words; empty where nothing is. */
    Optional<String> of(BoatSnapshot boat) {
        if (boat.link() != LinkState.LINKED) {
            return Optional.empty();
        }
        Optional<KeepStation> station =
                boat.command().filter(KeepStation.class::isInstance).map(KeepStation.class::cast);
        if (station.isPresent() && boat.pose().isPresent()) {
            return ofStation(boat, station.get());
        }
        stations.remove(boat.boat());
        return boat.drift().filter(drift -> drift.awayM() > IDLE_M).map(drift -> carried(boat.boat(), drift));
    }

    private static String carried(String boat, Drift drift) {
        String does = drift.isMoving() ? drift.words() : "has drifted";
        return String.format(Locale.ROOT, "%s %s: it is %.0f m from where it was left", boat, does, drift.awayM());
    }

    private Optional<String> ofStation(BoatSnapshot boat, KeepStation keep) {
        Station station = stations.get(boat.boat());
        if (station == null || !station.command.equals(keep.commandId())) {
            station = new Station(keep.commandId());
            stations.put(boat.boat(), station);
        }
        double awayM = Geodesy.distanceM(keep.point(), boat.pose().orElseThrow().position());
        station.reached |= boat.why().cause() == Cause.KEEPS_STATION;
        if (!station.reached || awayM <= keep.radiusM() + OUTSIDE_STATION_M) {
            station.outSinceMillis = Long.MAX_VALUE;
            return Optional.empty();
        }
        station.outSinceMillis = Math.min(station.outSinceMillis, boat.poseAtMillis());
        return boat.poseAtMillis() - station.outSinceMillis < OUT_FOR_MILLIS
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "%s drifts off its station: it is %.0f m from it and is to keep within %.0f m",
                        boat.boat(),
                        awayM,
                        keep.radiusM()));
    }
}

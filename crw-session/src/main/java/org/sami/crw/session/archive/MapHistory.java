package org.sami.crw.session.archive;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.MapModel;
import org.sami.crw.operator.map.ShownTrack;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SensorValue;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.value.GeoPoint;

/** Where boats were and what they measured in earlier processes, read from telemetry, for the map of a session that goes on. */
public final class MapHistory implements SessionTelemetry.Reader {
    private final Map<String, List<ShownTrack.Point>> tracks = new LinkedHashMap<>();
    private final List<FleetEvent.Measured> readings = new ArrayList<>();

    private MapHistory() {}

    /** Has the map show again what the rows tell; a row that makes no sense is left out. */
    public static void restore(List<TelemetryRow> rows, MapModel map) {
        MapHistory history = new MapHistory();
        SessionTelemetry.read(rows, history);
        List<ShownTrack> earlier = new ArrayList<>();
        history.tracks.forEach((boat, points) -> earlier.add(new ShownTrack(boat, points)));
        map.restoreHistory(earlier, history.readings);
    }

    /** Where each boat was last, by its id; a row that makes no sense is left out. */
    public static Map<String, GeoPoint> lastPositions(List<TelemetryRow> rows) {
        Map<String, GeoPoint> last = new HashMap<>();
        SessionTelemetry.Reader lastPose = new SessionTelemetry.Reader() {
            @Override
            public void pose(long atMillis, String boat, FleetHistory.Report report, double distanceM) {
                last.put(boat, report.position());
            }
        };
        for (int i = rows.size() - 1; i >= 0; i--) { // of the very many of a long session only the last are read
            TelemetryRow row = rows.get(i);
            if (row.kind().equals(SessionTelemetry.POSE) && !last.containsKey(row.proxy())) {
                SessionTelemetry.read(List.of(row), lastPose);
            }
        }
        return last;
    }

    @Override
    public void pose(long atMillis, String boat, FleetHistory.Report report, double distanceM) {
        tracks.computeIfAbsent(boat, id -> new ArrayList<>()).add(new ShownTrack.Point(report.position(), atMillis));
    }

    @Override
    public void reading(SensorValue value) {
        if (!value.values().isEmpty()) {
            readings.add(new FleetEvent.Measured(
                    value.boat(),
                    new BoatReading(
                            value.sensor(), value.channel(), value.values(), value.unit(), value.position(), 0)));
        }
    }
}

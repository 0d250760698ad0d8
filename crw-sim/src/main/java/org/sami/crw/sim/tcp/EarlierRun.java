package org.sami.crw.sim.tcp;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.crw.proxy.command.UploadCount;
import org.sami.crw.sim.run.record.NoteFold;
import org.sami.crw.sim.run.record.ReportFolds;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SensorValue;
import org.sami.session.record.SessionNote;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.value.GeoPoint;

/**
 * The telemetry of earlier processes of a run. Link histories and messages are restored at once; tracks and visits
 * when the area and its locations are known ({@link #feed}).
 */
final class EarlierRun implements SessionTelemetry.Reader {
    private final FleetHistory status;
    private final NoteFold notes;
    private final List<Pose> poses = new ArrayList<>();
    private final List<Visit> visits = new ArrayList<>();
    private final List<SensorValue> readings = new ArrayList<>();
    private final List<String> leftOut;
    private Optional<RunArea> area = Optional.empty();

    private record Pose(long atMillis, String boat, FleetHistory.Report report, double distanceM) {}

    private record Visit(long atMillis, String boat, GeoPoint location) {}

    EarlierRun(List<TelemetryRow> rows, FleetHistory status, NoteFold notes) {
        this.status = status;
        this.notes = notes;
        leftOut = SessionTelemetry.read(rows, this);
    }

    /** The area, if the boats had answered and it is still known. */
    Optional<RunArea> area() {
        return area;
    }

    /** An area that differs. */
    void know(RunArea found) {
        area = Optional.of(found);
    }

    /** Where each boat was first, as far as that is known. */
    List<GeoPoint> firstPositions() {
        Map<String, GeoPoint> first = new TreeMap<>();
        poses.forEach(pose -> first.putIfAbsent(pose.boat, pose.report.position()));
        return List.copyOf(first.values());
    }

    /** What was left out because it makes no sense, in words; empty if nothing was. */
    Optional<String> leftOut() {
        return leftOut.isEmpty()
                ? Optional.empty()
                : Optional.of("telemetry: " + leftOut.size() + (leftOut.size() == 1 ? " row makes" : " rows make")
                        + " no sense and left out; the first is '" + leftOut.get(0) + "'");
    }

    /**
     * Feeds a report with where boats were, what they visited and what they measured.
     *
     * @param folds know the locations: they have been fed the entries of the journal
     */
    void feed(ReportFolds folds, RunBoats boats) {
        for (Pose pose : poses) {
            status.restored(pose.boat, pose.report, pose.distanceM);
            boats.find(pose.boat).ifPresent(boat -> folds.pose(pose.atMillis, boat));
        }
        for (Visit visit : visits) {
            folds.visit(visit.boat, visit.location, visit.atMillis);
        }
        List<SensorValue> inOrder = new ArrayList<>(readings);
        inOrder.sort(Comparator.comparingLong(SensorValue::atMillis));
        inOrder.forEach(folds::reading);
    }

    @Override
    public void reading(SensorValue reading) {
        readings.add(reading);
    }

    @Override
    public void begun() {
        status.processBegan();
    }

    @Override
    public void other(TelemetryRow row, JsonNode json) {
        RunArea.noted(row, json).ifPresent(this::know);
    }

    @Override
    public void pose(long atMillis, String boat, FleetHistory.Report report, double distanceM) {
        poses.add(new Pose(atMillis, boat, report, distanceM));
    }

    @Override
    public void visited(long atMillis, String boat, GeoPoint location) {
        visits.add(new Visit(atMillis, boat, location));
    }

    @Override
    public void linked(String boat, String bootId) {
        status.linked(boat, bootId);
    }

    @Override
    public void lost(String boat) {
        status.lost(boat);
    }

    @Override
    public void address(String boat, String address) {
        status.isAt(boat, address);
    }

    @Override
    public void uploads(String boat, UploadCount uploads) {
        status.uploaded(boat, uploads);
    }

    @Override
    public void why(String boat, String text) {
        status.explained(boat, text);
    }

    @Override
    public void message(SessionNote note) {
        notes.onNote(note);
    }
}

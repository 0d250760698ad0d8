package org.sami.crw.report.file;

import static org.sami.crw.report.file.CsvTable.fixed;
import static org.sami.crw.report.file.CsvTable.seconds;

import java.util.ArrayList;
import java.util.List;
import org.sami.crw.report.Approach;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.LocationResult.Visit;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.ReadingResult;
import org.sami.crw.report.ReportPart;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TaskResult;
import org.sami.crw.report.TrackPoint;

/** The report's tables. Times are simulated seconds, lengths metres, angles degrees. */
final class ReportTables {
    private ReportTables() {}

    static CsvTable boats(RunReport report) {
        CsvTable table =
                new CsvTable("boat", "link", "distance_m", "battery_percent", "recharges", "locations_visited");
        for (BoatResult boat : report.boats()) {
            table.row(
                    boat.id(),
                    boat.link().words(),
                    fixed(boat.distanceM(), 2),
                    fixed(boat.batteryPercent(), 2),
                    boat.recharges(),
                    report.visitsBy(boat.id()));
        }
        return table;
    }

    static CsvTable locations(RunReport report) {
        CsvTable table = new CsvTable(
                "location",
                "lat_deg",
                "lon_deg",
                "east_m",
                "north_m",
                "visited",
                "visited_at_s",
                "boat",
                "reported",
                "reported_at_s",
                "reported_by",
                "nearest_m");
        for (LocationResult location : report.locations()) {
            table.row(
                    location.number(),
                    fixed(location.latDeg(), 7),
                    fixed(location.lonDeg(), 7),
                    fixed(location.eastM(), 3),
                    fixed(location.northM(), 3),
                    location.visited(),
                    location.visit().map(visit -> seconds(visit.atMillis())).orElse(""),
                    location.visit().map(Visit::boat).orElse(""),
                    location.reported().isPresent(),
                    location.reported().map(visit -> seconds(visit.atMillis())).orElse(""),
                    location.reported().map(Visit::boat).orElse(""),
                    nearest(location));
        }
        return table;
    }

    private static String nearest(LocationResult location) {
        return location.truth().isPresent() && location.truth().get().nearestM().isPresent()
                ? fixed(location.truth().get().nearestM().getAsDouble(), 2)
                : "";
    }

    /** Of every two boats that came too near to one another, where they were nearest. */
    static CsvTable approaches(RunReport report) {
        CsvTable table = new CsvTable("boat", "other", "at_s", "distance_m", "lat_deg", "lon_deg", "east_m", "north_m");
        for (Approach near : report.map().closest().near()) {
            table.row(
                    near.boat(),
                    near.other(),
                    seconds(near.atMillis()),
                    fixed(near.distanceM(), 2),
                    fixed(near.where().latDeg(), 7),
                    fixed(near.where().lonDeg(), 7),
                    fixed(near.where().eastM(), 3),
                    fixed(near.where().northM(), 3));
        }
        return table;
    }

    static CsvTable firings(RunReport report) {
        CsvTable table =
                new CsvTable("firing", "input", "at_s", "mission", "plan", "transition", "input_events", "tokens");
        for (FiringResult firing : report.firings()) {
            table.row(
                    firing.number(),
                    firing.input(),
                    seconds(firing.atMillis()),
                    firing.mission(),
                    firing.plan(),
                    firing.transition(),
                    firing.events(),
                    firing.moves());
        }
        return table;
    }

    /** Where each boat was. Heights are the last column, where one flew: files of boats alone are as they always were. */
    static CsvTable tracks(RunReport report) {
        boolean heights = report.boats().stream().anyMatch(BoatResult::flew);
        List<String> columns = new ArrayList<>(
                List.of("boat", "at_s", "lat_deg", "lon_deg", "east_m", "north_m", "speed_mps", "battery_percent"));
        if (heights) {
            columns.add("alt_m");
        }
        CsvTable table = new CsvTable(columns.toArray(String[]::new));
        for (BoatResult boat : report.boats()) {
            for (TrackPoint point : boat.track()) {
                List<Object> cells = new ArrayList<>(List.of(
                        boat.id(),
                        seconds(point.atMillis()),
                        fixed(point.latDeg(), 7),
                        fixed(point.lonDeg(), 7),
                        fixed(point.eastM(), 3),
                        fixed(point.northM(), 3),
                        fixed(point.speedMps(), 2),
                        fixed(point.batteryPercent(), 2)));
                if (heights) {
                    cells.add(fixed(point.altM(), 2));
                }
                table.row(cells.toArray());
            }
        }
        return table;
    }

    /** A reading of several values has a row for each, with its number from 1. */
    static CsvTable readings(RunReport report) {
        CsvTable table =
                new CsvTable("boat", "at_s", "sensor", "channel", "number", "value", "unit", "lat_deg", "lon_deg");
        for (ReadingResult reading : report.readings()) {
            int number = 1;
            for (double value : reading.values()) {
                table.row(
                        reading.boat(),
                        seconds(reading.atMillis()),
                        reading.sensor(),
                        reading.channel(),
                        number++,
                        fixed(value, 6),
                        reading.unit(),
                        fixed(reading.latDeg(), 7),
                        fixed(reading.lonDeg(), 7));
            }
        }
        return table;
    }

    static CsvTable decisions(RunReport report) {
        CsvTable table = new CsvTable(
                "decision",
                "mission",
                "type",
                "prompt",
                "opened_at_s",
                "closed_at_s",
                "answered_by",
                "answer",
                "clicks");
        for (DecisionResult decision : report.decisions()) {
            table.row(
                    decision.id(),
                    decision.mission(),
                    decision.type(),
                    decision.prompt(),
                    seconds(decision.openedAtMillis()),
                    decision.closedAtMillis().isPresent()
                            ? seconds(decision.closedAtMillis().getAsLong())
                            : "",
                    decision.by(),
                    decision.answer(),
                    decision.clicks());
        }
        return table;
    }

    static CsvTable tasks(RunReport report) {
        CsvTable table = new CsvTable(
                "mission", "task", "lat_deg", "lon_deg", "boat", "allocations", "started_at_s", "completed_at_s");
        for (TaskResult task : report.tasks()) {
            table.row(
                    task.mission(),
                    task.task(),
                    task.location().map(place -> fixed(place.latDeg(), 7)).orElse(""),
                    task.location().map(place -> fixed(place.lonDeg(), 7)).orElse(""),
                    task.boat(),
                    task.allocations(),
                    task.startedAtMillis().isPresent()
                            ? seconds(task.startedAtMillis().getAsLong())
                            : "",
                    task.isComplete() ? seconds(task.completedAtMillis().getAsLong()) : "");
        }
        return table;
    }

    static CsvTable interrupts(RunReport report) {
        CsvTable table = new CsvTable("interrupt", "boat", "trigger", "pressed_at_s", "presses", "taken", "taken_at_s");
        for (InterruptResult interrupt : report.interrupts()) {
            table.row(
                    interrupt.name(),
                    interrupt.boat(),
                    interrupt.trigger(),
                    interrupt.pressedAtMillis().isPresent()
                            ? seconds(interrupt.pressedAtMillis().getAsLong())
                            : "",
                    interrupt.presses(),
                    interrupt.taken(),
                    interrupt.taken() ? seconds(interrupt.takenAtMillis().getAsLong()) : "");
        }
        return table;
    }

    /** Messages to the operator, and notes of the engine. */
    static CsvTable messages(RunReport report) {
        CsvTable table = new CsvTable("at_s", "kind", "mission", "message");
        for (NoteResult note : report.notes()) {
            table.row(seconds(note.atMillis()), note.kind(), note.mission(), note.message());
        }
        return table;
    }

    /** The table that a part of the report has by itself. */
    static CsvTable of(ReportPart part) {
        CsvTable table = new CsvTable(part.columns().toArray(String[]::new));
        part.rows().forEach(row -> table.row(row.toArray()));
        return table;
    }
}

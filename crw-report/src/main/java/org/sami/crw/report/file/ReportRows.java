package org.sami.crw.report.file;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.jspecify.annotations.Nullable;
import org.sami.crw.report.Approach;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.report.LinkResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.LocationResult.Visit;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.ReadingSummary;
import org.sami.crw.report.TargetSummary;
import org.sami.crw.report.TaskResult;
import org.sami.crw.report.TrackPoint;

/** The objects in the report's JSON, a record for each kind: its components are the members, in their order. Times are in seconds. */
final class ReportRows {
    private ReportRows() {}

    record Position(BigDecimal latDeg, BigDecimal lonDeg) {
        static Position of(MapPoint point) {
            return new Position(degrees(point.latDeg()), degrees(point.lonDeg()));
        }
    }

    record Near(List<String> boats, BigDecimal at, BigDecimal distanceM, BigDecimal latDeg, BigDecimal lonDeg) {
        static Near of(Approach near) {
            return new Near(
                    List.of(near.boat(), near.other()),
                    seconds(near.atMillis()),
                    decimal(near.distanceM(), 2),
                    degrees(near.where().latDeg()),
                    degrees(near.where().lonDeg()));
        }
    }

    record Explored(
            BigDecimal askedAt,
            BigDecimal spacingM,
            BigDecimal areaM2,
            BigDecimal uncoveredM2,
            @Nullable BigDecimal plannedUncoveredM2,
            @Nullable BigDecimal reportedUncoveredM2,
            @Nullable BigDecimal trueUncoveredM2) {
        static Explored of(Exploration exploration) {
            return new Explored(
                    seconds(exploration.askedAtMillis()),
                    decimal(exploration.spacingM(), 2),
                    decimal(exploration.areaM2(), 1),
                    decimal(exploration.uncoveredM2(), 1),
                    orNull(exploration.left().plannedM2()),
                    orNull(exploration.left().reportedM2()),
                    orNull(exploration.left().trueM2()));
        }

        private static @Nullable BigDecimal orNull(Optional<Double> m2) {
            return m2.map(value -> decimal(value, 1)).orElse(null);
        }
    }

    @JsonInclude(JsonInclude.Include.NON_NULL)
    record Boat(
            String id,
            String link,
            String bootId,
            int linkLost,
            int linkBack,
            LinkResult.Uploads uploads,
            BigDecimal distanceM,
            BigDecimal batteryPercent,
            int recharges,
            @Nullable BigDecimal altM,
            @Nullable BigDecimal highestAltM,
            String why) {
        static Boat of(BoatResult boat) {
            LinkResult link = boat.link();
            Optional<BoatResult> flew = Optional.of(boat).filter(BoatResult::flew);
            return new Boat(
                    boat.id(),
                    link.words(),
                    link.bootId(),
                    link.lost(),
                    link.reconnected(),
                    link.uploads(),
                    decimal(boat.distanceM(), 2),
                    decimal(boat.batteryPercent(), 2),
                    boat.recharges(),
                    flew.map(one -> decimal(
                                    one.track().get(one.track().size() - 1).altM(), 2))
                            .orElse(null),
                    flew.map(one -> decimal(highestM(one), 2)).orElse(null),
                    link.why());
        }
    }

    private static double highestM(BoatResult boat) {
        return boat.track().stream().mapToDouble(TrackPoint::altM).max().orElse(0);
    }

    @JsonInclude(JsonInclude.Include.NON_NULL)
    record Location(
            int number,
            BigDecimal latDeg,
            BigDecimal lonDeg,
            boolean visited,
            @Nullable BigDecimal visitedAt,
            @Nullable String visitedBy,
            boolean reported,
            @Nullable BigDecimal reportedAt,
            @Nullable String reportedBy,
            @Nullable BigDecimal nearestM) {
        static Location of(LocationResult location) {
            OptionalDouble near =
                    location.truth().map(LocationResult.Truth::nearestM).orElse(OptionalDouble.empty());
            return new Location(
                    location.number(),
                    degrees(location.latDeg()),
                    degrees(location.lonDeg()),
                    location.visited(),
                    at(location.visit()),
                    location.visit().map(Visit::boat).orElse(null),
                    location.reported().isPresent(),
                    at(location.reported()),
                    location.reported().map(Visit::boat).orElse(null),
                    near.isPresent() ? decimal(near.getAsDouble(), 2) : null);
        }

        private static @Nullable BigDecimal at(Optional<Visit> visit) {
            return visit.map(one -> seconds(one.atMillis())).orElse(null);
        }
    }

    @JsonInclude(JsonInclude.Include.NON_NULL)
    record Interrupt(
            String name,
            String boat,
            String trigger,
            @Nullable BigDecimal pressedAt,
            int presses,
            boolean taken,
            @Nullable BigDecimal takenAt) {
        static Interrupt of(InterruptResult interrupt) {
            return new Interrupt(
                    interrupt.name(),
                    interrupt.boat(),
                    interrupt.trigger(),
                    seconds(interrupt.pressedAtMillis()),
                    interrupt.presses(),
                    interrupt.taken(),
                    seconds(interrupt.takenAtMillis()));
        }
    }

    @JsonInclude(JsonInclude.Include.NON_NULL)
    record Task(
            long mission,
            String task,
            @Nullable BigDecimal latDeg,
            @Nullable BigDecimal lonDeg,
            String boat,
            int allocations,
            @Nullable BigDecimal startedAt,
            boolean complete,
            @Nullable BigDecimal completedAt) {
        static Task of(TaskResult task) {
            return new Task(
                    task.mission(),
                    task.task(),
                    task.location().map(place -> degrees(place.latDeg())).orElse(null),
                    task.location().map(place -> degrees(place.lonDeg())).orElse(null),
                    task.boat(),
                    task.allocations(),
                    seconds(task.startedAtMillis()),
                    task.isComplete(),
                    seconds(task.completedAtMillis()));
        }
    }

    @JsonInclude(JsonInclude.Include.NON_NULL)
    record Question(
            long id,
            String type,
            BigDecimal openedAt,
            @Nullable BigDecimal closedAt,
            String by,
            int clicks) {
        static Question of(DecisionResult decision) {
            return new Question(
                    decision.id(),
                    decision.type(),
                    seconds(decision.openedAtMillis()),
                    seconds(decision.closedAtMillis()),
                    decision.by(),
                    decision.clicks());
        }
    }

    record Note(BigDecimal at, String kind, long mission, String message) {
        static Note of(NoteResult note) {
            return new Note(seconds(note.atMillis()), note.kind(), note.mission(), note.message());
        }
    }

    record Channel(
            String sensor, String channel, String unit, int count, BigDecimal least, BigDecimal mean, BigDecimal most) {
        static Channel of(ReadingSummary summary) {
            return new Channel(
                    summary.sensor(),
                    summary.channel(),
                    summary.unit(),
                    summary.count(),
                    decimal(summary.least(), 6),
                    decimal(summary.mean(), 6),
                    decimal(summary.most(), 6));
        }
    }

    record Target(int number, BigDecimal latDeg, BigDecimal lonDeg, int count, BigDecimal firstAt, List<String> boats) {
        static Target of(TargetSummary target) {
            return new Target(
                    target.number(),
                    degrees(target.latDeg()),
                    degrees(target.lonDeg()),
                    target.count(),
                    seconds(target.firstAtMillis()),
                    target.boats());
        }
    }

    static BigDecimal seconds(long millis) {
        return BigDecimal.valueOf(millis, 3).stripTrailingZeros();
    }

    private static @Nullable BigDecimal seconds(OptionalLong millis) {
        return millis.isPresent() ? seconds(millis.getAsLong()) : null;
    }

    private static BigDecimal degrees(double value) {
        return decimal(value, 7);
    }

    static BigDecimal decimal(double value, int digits) {
        return BigDecimal.valueOf(value).setScale(digits, RoundingMode.HALF_UP).stripTrailingZeros();
    }
}

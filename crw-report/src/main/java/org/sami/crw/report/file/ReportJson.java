package org.sami.crw.report.file;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Optional;
import org.sami.crw.operator.mission.Wait;
import org.sami.crw.report.Approach;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.report.LinkResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.ReadingSummary;
import org.sami.crw.report.RunHeader;
import org.sami.crw.report.RunOrigin;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.RunResult;
import org.sami.crw.report.TaskResult;

/** The report as one JSON object. Its members are described in docs/command-line.md; programs rely on them. */
public final class ReportJson {
    private static final ObjectMapper MAPPER = new ObjectMapper()
            .enable(SerializationFeature.INDENT_OUTPUT)
            .enable(JsonGenerator.Feature.WRITE_BIGDECIMAL_AS_PLAIN);
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private ReportJson() {}

    /** The report's text, indented, with a line feed at its end. */
    public static String text(RunReport report) {
        try {
            return MAPPER.writeValueAsString(object(report)) + "\n";
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("a tree of plain nodes was not writable", e);
        }
    }

    private static ObjectNode object(RunReport report) {
        RunHeader header = report.header();
        RunResult result = report.result();
        ObjectNode json = NODES.objectNode();
        json.put("outcome", result.outcome().word());
        json.put("reason", result.reason());
        json.put("plan", header.plan());
        json.put("planName", header.planName());
        json.put("planHash", header.planHash());
        json.put("mission", header.mission());
        origin(json, report);
        json.set("centre", position(header.place().centre()));
        json.set(
                "quay",
                header.place().quay().<JsonNode>map(ReportJson::position).orElse(NODES.nullNode()));
        json.put("seed", header.seed());
        json.put("speed", header.speed());
        json.put("simulatedSeconds", seconds(result.simulatedMillis()));
        json.put("wallSeconds", decimal(result.wallSeconds(), 3));
        json.put("clicks", result.clicks());
        json.put("firings", result.firings());
        json.put("locationsVisited", report.locationsVisited());
        json.put("locationsReported", report.locationsReported());
        json.put("distanceM", decimal(report.distanceM(), 2));
        ArrayNode problems = json.putArray("problems");
        report.problems().forEach(problem -> problems.add(problem.message()));
        json.set("waitsFor", waits(report));
        json.set("closestApproach", approach(report.map().closest().ever()));
        json.set("closestUnderWay", approach(report.map().closest().underWay()));
        ArrayNode near = json.putArray("nearApproaches");
        report.map().closest().near().forEach(pair -> near.add(approach(Optional.of(pair))));
        json.set("explorations", explorations(report));
        json.set("boats", boats(report));
        json.set("locations", locations(report));
        json.set("interrupts", interrupts(report));
        json.set("tasks", tasks(report));
        json.set("decisions", decisions(report));
        json.set("notes", notes(report));
        report.parts().forEach(part -> json.set(part.name(), MAPPER.valueToTree(part.json())));
        json.set("readings", readings(report));
        if (result.resumedFrom().isPresent()) {
            json.put("resumedFrom", result.resumedFrom().getAsLong());
        } else {
            json.putNull("resumedFrom");
        }
        json.put("runHash", result.runHash());
        return json;
    }

    private static void origin(ObjectNode json, RunReport report) {
        json.put(
                "startedAt",
                report.origin().map(from -> from.startedAt().toString()).orElse(null));
        json.put("timeZone", report.origin().map(from -> from.zone().getId()).orElse(null));
        json.put("version", report.origin().map(RunOrigin::version).orElse(null));
    }

    private static JsonNode approach(Optional<Approach> approach) {
        return approach.<JsonNode>map(near -> {
                    ObjectNode node = NODES.objectNode();
                    node.putArray("boats").add(near.boat()).add(near.other());
                    return node.put("at", seconds(near.atMillis()))
                            .put("distanceM", decimal(near.distanceM(), 2))
                            .put("latDeg", decimal(near.where().latDeg(), 7))
                            .put("lonDeg", decimal(near.where().lonDeg(), 7));
                })
                .orElse(NODES.nullNode());
    }

    private static ArrayNode explorations(RunReport report) {
        ArrayNode array = NODES.arrayNode();
        for (Exploration exploration : report.map().explorations()) {
            Exploration.Left left = exploration.left();
            array.addObject()
                    .put("askedAt", seconds(exploration.askedAtMillis()))
                    .put("spacingM", decimal(exploration.spacingM(), 2))
                    .put("areaM2", decimal(exploration.areaM2(), 1))
                    .put("uncoveredM2", decimal(exploration.uncoveredM2(), 1))
                    .put("plannedUncoveredM2", orNull(left.plannedM2()))
                    .put("reportedUncoveredM2", orNull(left.reportedM2()))
                    .put("trueUncoveredM2", orNull(left.trueM2()));
        }
        return array;
    }

    private static BigDecimal orNull(Optional<Double> m2) {
        return m2.map(value -> decimal(value, 1)).orElse(null);
    }

    private static ObjectNode position(MapPoint point) {
        return NODES.objectNode().put("latDeg", decimal(point.latDeg(), 7)).put("lonDeg", decimal(point.lonDeg(), 7));
    }

    private static ArrayNode boats(RunReport report) {
        ArrayNode array = NODES.arrayNode();
        for (BoatResult boat : report.boats()) {
            LinkResult link = boat.link();
            ObjectNode node = array.addObject()
                    .put("id", boat.id())
                    .put("link", link.words())
                    .put("bootId", link.bootId())
                    .put("linkLost", link.lost())
                    .put("linkBack", link.reconnected());
            node.putObject("uploads")
                    .put("sent", link.uploads().sent())
                    .put("acknowledged", link.uploads().acknowledged())
                    .put("readBackEqual", link.uploads().readBackEqual())
                    .put("failed", link.uploads().failed());
            node.put("distanceM", decimal(boat.distanceM(), 2))
                    .put("batteryPercent", decimal(boat.batteryPercent(), 2))
                    .put("recharges", boat.recharges())
                    .put("why", link.why());
        }
        return array;
    }

    private static ArrayNode waits(RunReport report) {
        ArrayNode array = NODES.arrayNode();
        for (Wait wait : report.waits()) {
            ObjectNode node = array.addObject().put("missions", wait.missions()).put("plan", wait.plan());
            node.put("place", wait.place());
            wait.tokens().forEach(node.putArray("tokens")::add);
            node.put("occurrence", wait.occurrence());
            ArrayNode transitions = node.putArray("transitions");
            for (Wait.BlockedTransition blocked : wait.transitions()) {
                ArrayNode reasons =
                        transitions.addObject().put("name", blocked.name()).putArray("reasons");
                blocked.reasons().forEach(reasons::add);
            }
        }
        return array;
    }

    private static ArrayNode locations(RunReport report) {
        ArrayNode array = NODES.arrayNode();
        for (LocationResult location : report.locations()) {
            ObjectNode node = array.addObject();
            node.put("number", location.number());
            node.put("latDeg", decimal(location.latDeg(), 7));
            node.put("lonDeg", decimal(location.lonDeg(), 7));
            node.put("visited", location.visited());
            location.visit()
                    .ifPresent(visit ->
                            node.put("visitedAt", seconds(visit.atMillis())).put("visitedBy", visit.boat()));
            node.put("reported", location.reported().isPresent());
            location.reported()
                    .ifPresent(visit ->
                            node.put("reportedAt", seconds(visit.atMillis())).put("reportedBy", visit.boat()));
            location.truth()
                    .ifPresent(truth -> truth.nearestM().ifPresent(near -> node.put("nearestM", decimal(near, 2))));
        }
        return array;
    }

    private static ArrayNode interrupts(RunReport report) {
        ArrayNode array = NODES.arrayNode();
        for (InterruptResult interrupt : report.interrupts()) {
            ObjectNode node = array.addObject();
            node.put("name", interrupt.name());
            node.put("boat", interrupt.boat());
            node.put("trigger", interrupt.trigger());
            interrupt.pressedAtMillis().ifPresent(at -> node.put("pressedAt", seconds(at)));
            node.put("presses", interrupt.presses());
            node.put("taken", interrupt.taken());
            interrupt.takenAtMillis().ifPresent(at -> node.put("takenAt", seconds(at)));
        }
        return array;
    }

    private static ArrayNode tasks(RunReport report) {
        ArrayNode array = NODES.arrayNode();
        for (TaskResult task : report.tasks()) {
            ObjectNode node = array.addObject().put("mission", task.mission()).put("task", task.task());
            task.location()
                    .ifPresent(place ->
                            node.put("latDeg", decimal(place.latDeg(), 7)).put("lonDeg", decimal(place.lonDeg(), 7)));
            node.put("boat", task.boat()).put("allocations", task.allocations());
            task.startedAtMillis().ifPresent(at -> node.put("startedAt", seconds(at)));
            node.put("complete", task.isComplete());
            task.completedAtMillis().ifPresent(at -> node.put("completedAt", seconds(at)));
        }
        return array;
    }

    private static ArrayNode decisions(RunReport report) {
        ArrayNode array = NODES.arrayNode();
        for (DecisionResult decision : report.decisions()) {
            ObjectNode node = array.addObject();
            node.put("id", decision.id());
            node.put("type", decision.type());
            node.put("openedAt", seconds(decision.openedAtMillis()));
            decision.closedAtMillis().ifPresent(at -> node.put("closedAt", seconds(at)));
            node.put("by", decision.by());
            node.put("clicks", decision.clicks());
        }
        return array;
    }

    private static ArrayNode notes(RunReport report) {
        ArrayNode array = NODES.arrayNode();
        for (NoteResult note : report.notes()) {
            array.addObject()
                    .put("at", seconds(note.atMillis()))
                    .put("kind", note.kind())
                    .put("mission", note.mission())
                    .put("message", note.message());
        }
        return array;
    }

    private static ArrayNode readings(RunReport report) {
        ArrayNode array = NODES.arrayNode();
        for (ReadingSummary channel : ReadingSummary.of(report.readings())) {
            array.addObject()
                    .put("sensor", channel.sensor())
                    .put("channel", channel.channel())
                    .put("unit", channel.unit())
                    .put("count", channel.count())
                    .put("least", decimal(channel.least(), 6))
                    .put("mean", decimal(channel.mean(), 6))
                    .put("most", decimal(channel.most(), 6));
        }
        return array;
    }

    private static BigDecimal seconds(long millis) {
        return BigDecimal.valueOf(millis, 3).stripTrailingZeros();
    }

    private static BigDecimal decimal(double value, int digits) {
        return BigDecimal.valueOf(value).setScale(digits, RoundingMode.HALF_UP).stripTrailingZeros();
    }
}

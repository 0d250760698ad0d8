package org.sami.crw.report.file;

import static org.sami.crw.report.file.ReportRows.decimal;
import static org.sami.crw.report.file.ReportRows.seconds;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.ReadingSummary;
import org.sami.crw.report.RunHeader;
import org.sami.crw.report.RunOrigin;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.RunResult;
import org.sami.crw.report.TargetSummary;
import org.sami.crw.report.file.ReportRows.Boat;
import org.sami.crw.report.file.ReportRows.Channel;
import org.sami.crw.report.file.ReportRows.Explored;
import org.sami.crw.report.file.ReportRows.Interrupt;
import org.sami.crw.report.file.ReportRows.Location;
import org.sami.crw.report.file.ReportRows.Near;
import org.sami.crw.report.file.ReportRows.Note;
import org.sami.crw.report.file.ReportRows.Position;
import org.sami.crw.report.file.ReportRows.Question;
import org.sami.crw.report.file.ReportRows.Target;
import org.sami.crw.report.file.ReportRows.Task;

/** The report as one JSON object. Its members are described in docs/command-line.md; programs rely on them. */
public final class ReportJson {
    private static final ObjectMapper MAPPER = new ObjectMapper()
            .enable(SerializationFeature.INDENT_OUTPUT)
            .enable(JsonGenerator.Feature.WRITE_BIGDECIMAL_AS_PLAIN);

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
        ObjectNode json = MAPPER.createObjectNode();
        json.put("outcome", result.outcome().word());
        json.put("reason", result.reason());
        json.put("plan", header.plan());
        json.put("planName", header.planName());
        json.put("planHash", header.planHash());
        json.put("mission", header.mission());
        origin(json, report);
        set(json, "centre", Position.of(header.place().centre()));
        set(json, "quay", header.place().quay().map(Position::of).orElse(null));
        json.put("seed", header.seed());
        json.put("speed", header.speed());
        json.put("simulatedSeconds", seconds(result.simulatedMillis()));
        json.put("wallSeconds", decimal(result.wallSeconds(), 3));
        json.put("clicks", result.clicks());
        json.put("firings", result.firings());
        json.put("locationsVisited", report.locationsVisited());
        json.put("locationsReported", report.locationsReported());
        json.put("distanceM", decimal(report.distanceM(), 2));
        set(json, "problems", rows(report.problems(), NoteResult::message));
        set(json, "waitsFor", report.waits());
        var closest = report.map().closest();
        set(json, "closestApproach", closest.ever().map(Near::of).orElse(null));
        set(json, "closestUnderWay", closest.underWay().map(Near::of).orElse(null));
        set(json, "nearApproaches", rows(closest.near(), Near::of));
        set(json, "explorations", rows(report.map().explorations(), Explored::of));
        set(json, "boats", rows(report.boats(), Boat::of));
        set(json, "locations", rows(report.locations(), Location::of));
        set(json, "interrupts", rows(report.interrupts(), Interrupt::of));
        set(json, "tasks", rows(report.tasks(), Task::of));
        set(json, "decisions", rows(report.decisions(), Question::of));
        set(json, "notes", rows(report.notes(), Note::of));
        report.parts().forEach(part -> set(json, part.name(), part.json()));
        set(json, "readings", rows(ReadingSummary.of(report.readings()), Channel::of));
        List<TargetSummary> targets = TargetSummary.of(report.readings());
        if (!targets.isEmpty()) {
            set(json, "targets", rows(targets, Target::of));
        }
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

    /** The value under a name: records as objects, null where there is none. */
    private static void set(ObjectNode json, String name, @Nullable Object value) {
        json.set(name, MAPPER.valueToTree(value));
    }

    private static <T> List<?> rows(List<T> results, Function<T, ?> row) {
        return results.stream().map(row).toList();
    }
}

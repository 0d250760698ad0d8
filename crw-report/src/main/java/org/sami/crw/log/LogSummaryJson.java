package org.sami.crw.log;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.RoundingMode;
import org.sami.spn.value.GeoPoint;

/** What a log holds, as one JSON object. Its members are described in docs/command-line.md; programs rely on them. */
public final class LogSummaryJson {
    private static final ObjectMapper MAPPER = new ObjectMapper()
            .enable(SerializationFeature.INDENT_OUTPUT)
            .enable(JsonGenerator.Feature.WRITE_BIGDECIMAL_AS_PLAIN);

    private LogSummaryJson() {}

    /** The summary's text, indented, with a line feed at its end. */
    public static String text(LogSummary summary) {
        try {
            return MAPPER.writeValueAsString(object(summary)) + "\n";
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("a tree of plain nodes was not writable", e);
        }
    }

    private static ObjectNode object(LogSummary summary) {
        ObjectNode json = JsonNodeFactory.instance.objectNode();
        json.put("source", summary.source());
        json.put("bytes", summary.bytes());
        json.put("lines", summary.lines());
        json.put("entries", summary.entries());
        json.put("unreadLines", summary.unreadLines());
        json.put("firstClock", summary.firstClock());
        json.put("durationSeconds", BigDecimal.valueOf(summary.durationMillis(), 3));
        ObjectNode topics = json.putObject("topics");
        summary.topics().forEach(topics::put);
        json.set("poses", track(summary.poses()));
        json.set("fixes", track(summary.fixes()));
        ArrayNode leftOut = json.putArray("stretchesNotInPicture");
        LogPicture.leftOut(summary).forEach(stretch -> leftOut.add(stretch.number()));
        ArrayNode channels = json.putArray("channels");
        for (ChannelSummary channel : summary.channels()) {
            ObjectNode node = channels.addObject();
            node.put("sensor", channel.sensor());
            node.put("channel", channel.channel());
            node.put("values", channel.values());
            number(node, "least", channel.least());
            number(node, "most", channel.most());
            number(node, "last", channel.last());
        }
        ArrayNode problems = json.putArray("problems");
        for (FaultCount problem : summary.problems()) {
            ObjectNode node = problems.addObject();
            node.put("problem", problem.fault().word());
            node.put("count", problem.count());
            ArrayNode lines = node.putArray("lines");
            problem.lines().forEach(lines::add);
            node.put("example", problem.example());
        }
        return json;
    }

    private static ObjectNode track(LoggedTrack track) {
        ObjectNode json = JsonNodeFactory.instance.objectNode();
        json.put("positions", track.positions());
        json.put("distanceM", decimal(track.distanceM(), 1));
        json.put("stretchCount", track.stretchCount());
        ArrayNode stretches = json.putArray("stretches");
        for (TrackSegment stretch : track.stretches()) {
            ObjectNode node = stretches.addObject();
            node.put("number", stretch.number());
            node.put("firstLine", stretch.firstLine());
            node.put("startSeconds", BigDecimal.valueOf(stretch.startMillis(), 3));
            node.put("endSeconds", BigDecimal.valueOf(stretch.endMillis(), 3));
            node.put("positions", stretch.positions());
            node.put("distanceM", decimal(stretch.distanceM(), 1));
            node.set("first", point(stretch.first()));
            node.set("last", point(stretch.last()));
        }
        return json;
    }

    private static ObjectNode point(GeoPoint point) {
        return JsonNodeFactory.instance
                .objectNode()
                .put("latDeg", decimal(point.latDeg(), 7))
                .put("lonDeg", decimal(point.lonDeg(), 7));
    }

    /** JSON has no word for what is no number: null. */
    private static void number(ObjectNode node, String name, double value) {
        if (Double.isFinite(value)) {
            node.put(name, BigDecimal.valueOf(value));
        } else {
            node.putNull(name);
        }
    }

    private static BigDecimal decimal(double value, int digits) {
        return BigDecimal.valueOf(value).setScale(digits, RoundingMode.HALF_UP);
    }
}

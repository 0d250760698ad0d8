package org.sami.crw.log;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamWriteFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.cfg.JsonNodeFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Collection;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sami.spn.value.GeoPoint;

/** What a log holds, as one JSON object. Its members are described in docs/command-line.md; programs rely on them. */
public final class LogSummaryJson {
    /** Numbers keep the digits to which they were rounded. */
    private static final ObjectMapper MAPPER = JsonMapper.builder()
            .enable(SerializationFeature.INDENT_OUTPUT)
            .enable(StreamWriteFeature.WRITE_BIGDECIMAL_AS_PLAIN)
            .disable(JsonNodeFeature.STRIP_TRAILING_BIGDECIMAL_ZEROES)
            .build();

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
        ObjectNode json = MAPPER.createObjectNode()
                .put("source", summary.source())
                .put("bytes", summary.bytes())
                .put("lines", summary.lines())
                .put("entries", summary.entries())
                .put("unreadLines", summary.unreadLines())
                .put("firstClock", summary.firstClock())
                .put("durationSeconds", seconds(summary.durationMillis()));
        set(json, "topics", summary.topics());
        set(json, "poses", Track.of(summary.poses()));
        set(json, "fixes", Track.of(summary.fixes()));
        set(json, "stretchesNotInPicture", rows(LogPicture.leftOut(summary), TrackSegment::number));
        set(json, "channels", rows(summary.channels(), Channel::of));
        set(json, "problems", rows(summary.problems(), Problem::of));
        return json;
    }

    private static void set(ObjectNode json, String name, Object value) {
        json.set(name, MAPPER.valueToTree(value));
    }

    private static <T> List<?> rows(Collection<T> found, Function<T, ?> row) {
        return found.stream().map(row).toList();
    }

    private record Track(long positions, BigDecimal distanceM, int stretchCount, List<?> stretches) {
        static Track of(LoggedTrack track) {
            return new Track(
                    track.positions(),
                    decimal(track.distanceM(), 1),
                    track.stretchCount(),
                    rows(track.stretches(), Stretch::of));
        }
    }

    private record Stretch(
            int number,
            long firstLine,
            BigDecimal startSeconds,
            BigDecimal endSeconds,
            long positions,
            BigDecimal distanceM,
            Position first,
            Position last) {
        static Stretch of(TrackSegment stretch) {
            return new Stretch(
                    stretch.number(),
                    stretch.firstLine(),
                    seconds(stretch.startMillis()),
                    seconds(stretch.endMillis()),
                    stretch.positions(),
                    decimal(stretch.distanceM(), 1),
                    Position.of(stretch.first()),
                    Position.of(stretch.last()));
        }
    }

    private record Position(BigDecimal latDeg, BigDecimal lonDeg) {
        static Position of(GeoPoint point) {
            return new Position(decimal(point.latDeg(), 7), decimal(point.lonDeg(), 7));
        }
    }

    private record Channel(
            String sensor,
            String channel,
            long values,
            @Nullable BigDecimal least,
            @Nullable BigDecimal most,
            @Nullable BigDecimal last) {
        static Channel of(ChannelSummary channel) {
            return new Channel(
                    channel.sensor(),
                    channel.channel(),
                    channel.values(),
                    orNull(channel.least()),
                    orNull(channel.most()),
                    orNull(channel.last()));
        }

        /** JSON has no word for what is no number: null. */
        private static @Nullable BigDecimal orNull(double value) {
            return Double.isFinite(value) ? BigDecimal.valueOf(value) : null;
        }
    }

    private record Problem(String problem, long count, List<?> lines, String example) {
        static Problem of(FaultCount fault) {
            return new Problem(fault.fault().word(), fault.count(), fault.lines(), fault.example());
        }
    }

    private static BigDecimal seconds(long millis) {
        return BigDecimal.valueOf(millis, 3);
    }

    private static BigDecimal decimal(double value, int digits) {
        return BigDecimal.valueOf(value).setScale(digits, RoundingMode.HALF_UP);
    }
}

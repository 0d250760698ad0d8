package org.sami.crw.log;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.sami.crw.report.ReportWords;

/** What a log holds, for a terminal. */
public final class LogSummaryText {
    private static final int STRETCHES_SHOWN = 10;
    private static final int LINES_SHOWN = 8;

    private LogSummaryText() {}

    /** The summary, with line feeds, about one screen. */
    public static String text(LogSummary summary) {
        StringBuilder text = new StringBuilder();
        line(text, "%s", summary.source());
        line(
                text,
                "  %-20s%d, %d of them entries, %d unread",
                "lines",
                summary.lines(),
                summary.entries(),
                summary.unreadLines());
        line(
                text,
                "  %-20s%s, from %s on",
                "time",
                ReportWords.duration(summary.durationMillis()),
                summary.firstClock());
        line(
                text,
                "  %-20s%s",
                "entries",
                summary.topics().entrySet().stream()
                        .map(topic -> topic.getValue() + " " + topic.getKey())
                        .collect(Collectors.joining(", ")));
        track(text, "poses", summary.poses());
        track(text, "satellite fixes", summary.fixes());
        leftOut(text, LogPicture.leftOut(summary));
        channels(text, summary.channels());
        problems(text, summary.problems());
        return text.toString();
    }

    private static void track(StringBuilder text, String name, LoggedTrack track) {
        if (track.positions() == 0) {
            line(text, "  %-20snone", name);
            return;
        }
        line(
                text,
                "  %-20s%d over %.0f m in %s",
                name,
                track.positions(),
                track.distanceM(),
                counted(track.stretchCount(), "stretch", "stretches"));
        for (TrackSegment stretch :
                track.stretches().stream().limit(STRETCHES_SHOWN).toList()) {
            line(
                    text,
                    "    %d, from line %d: %d over %.0f m, %.1f s to %.1f s, %.6f, %.6f to %.6f, %.6f",
                    stretch.number(),
                    stretch.firstLine(),
                    stretch.positions(),
                    stretch.distanceM(),
                    stretch.startMillis() / 1000.0,
                    stretch.endMillis() / 1000.0,
                    stretch.first().latDeg(),
                    stretch.first().lonDeg(),
                    stretch.last().latDeg(),
                    stretch.last().lonDeg());
        }
        if (track.stretchCount() > STRETCHES_SHOWN) {
            line(text, "    and %d more", track.stretchCount() - STRETCHES_SHOWN);
        }
    }

    private static void leftOut(StringBuilder text, List<TrackSegment> leftOut) {
        if (!leftOut.isEmpty()) {
            line(
                    text,
                    "  %-20sstretches too far from the longest: %s",
                    "not in the picture",
                    leftOut.stream()
                            .limit(STRETCHES_SHOWN)
                            .map(stretch -> String.valueOf(stretch.number()))
                            .collect(Collectors.joining(", ", "", leftOut.size() > STRETCHES_SHOWN ? ", ..." : "")));
        }
    }

    private static void channels(StringBuilder text, List<ChannelSummary> channels) {
        if (channels.isEmpty()) {
            return;
        }
        line(text, "");
        line(text, "  %-34s%8s%16s%16s%16s", "sensor and channel", "values", "least", "most", "last");
        for (ChannelSummary channel : channels) {
            line(
                    text,
                    "  %-34s%8d%16.6g%16.6g%16.6g",
                    channel.sensor() + " " + channel.channel(),
                    channel.values(),
                    channel.least(),
                    channel.most(),
                    channel.last());
        }
    }

    private static void problems(StringBuilder text, List<FaultCount> problems) {
        if (problems.isEmpty()) {
            return;
        }
        line(text, "");
        line(text, "  problems");
        for (FaultCount problem : problems) {
            String lines = problem.lines().stream()
                    .limit(LINES_SHOWN)
                    .map(String::valueOf)
                    .collect(Collectors.joining(", "));
            line(
                    text,
                    "  %8d  %s: line %s%s (%s)",
                    problem.count(),
                    problem.fault().word(),
                    lines,
                    problem.count() > LINES_SHOWN ? ", ..." : "",
                    problem.example());
        }
    }

    private static String counted(int count, String one, String many) {
        return count + " " + (count == 1 ? one : many);
    }

    private static void line(StringBuilder text, String format, Object... values) {
        text.append(String.format(Locale.ROOT, format, values)).append('\n');
    }
}

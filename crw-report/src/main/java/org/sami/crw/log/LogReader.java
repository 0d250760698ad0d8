package org.sami.crw.log;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** Reads a log once, summarises it, and writes its tables where requested. */
final class LogReader {
    /** If none of so many lines is an entry, the file is something else; a damaged log begins well. */
    private static final int TRIED = 1000;

    private static final int TEXT_KEPT = 500;

    private final LineParser parser = new LineParser();
    private final TrackBuilder poses = new TrackBuilder();
    private final TrackBuilder fixes = new TrackBuilder();
    private final ChannelSummary.Collector channels = new ChannelSummary.Collector();
    private final FaultCount.Counter problems = new FaultCount.Counter();
    private final Map<String, Long> topics = new LinkedHashMap<>();
    private final Optional<LogTables> tables;
    private long entries;
    private String firstClock = "";
    private long firstMillis;
    private long latestMillis;
    private String firstMessage = "";

    LogReader(Optional<LogTables> tables) {
        this.tables = tables;
    }

    LogSummary read(Path file) throws IOException {
        try (LogLines lines = LogLines.open(file)) {
            long count = 0;
            for (Optional<LogLines.Line> next = lines.next(); next.isPresent(); next = lines.next()) {
                count = next.get().number();
                take(next.get());
                if (count == TRIED && entries == 0) {
                    break;
                }
            }
            if (entries == 0) {
                throw new NotALogException("is no log of a boat: none of its "
                        + (count == TRIED ? "first " : "")
                        + count
                        + " lines is an entry such as '2480703 18:36:22,325 COMPASS: -1.15'; line 1: "
                        + firstMessage);
            }
            return new LogSummary(
                    file.toString(),
                    lines.bytesRead(),
                    count,
                    entries,
                    firstClock,
                    latestMillis - firstMillis,
                    topics,
                    poses.finish(),
                    fixes.finish(),
                    channels.summaries(),
                    problems.counts());
        }
    }

    private void take(LogLines.Line line) throws IOException {
        if (line.text().isBlank() && line.ended()) {
            return; // says nothing, so nothing is lost
        }
        if (!line.whole()) {
            problem(line, LineFault.TOO_LONG, "it has more than " + LogLines.MOST_BYTES + " bytes");
            return;
        }
        try {
            entry(line, parser.parse(line.number(), line.text()));
        } catch (BadLineException e) {
            boolean cutOff = !line.ended() && e.fault() != LineFault.UNKNOWN_TOPIC;
            problem(line, cutOff ? LineFault.CUT_OFF : e.fault(), String.valueOf(e.getMessage()));
        }
    }

    private void entry(LogLines.Line raw, LoggedLine line) throws IOException {
        if (entries == 0) {
            firstClock = line.clock();
            firstMillis = line.atMillis();
            latestMillis = line.atMillis();
        }
        entries++;
        topics.merge(line.topic(), 1L, Long::sum);
        if (line.atMillis() < latestMillis) {
            problem(
                    raw,
                    LineFault.TIME_WENT_BACK,
                    "its " + line.atMillis() + " ms are before the " + latestMillis + " ms of an earlier line");
        }
        latestMillis = Math.max(latestMillis, line.atMillis());
        long atMillis = line.atMillis() - firstMillis;
        OptionalInt stretch = position(line, atMillis);
        if (line.entry() instanceof LogEntry.Reading reading) {
            channels.add(reading);
        }
        if (tables.isPresent()) {
            tables.get().entry(line, atMillis, stretch);
        }
    }

    private OptionalInt position(LoggedLine line, long atMillis) {
        if (line.entry() instanceof LogEntry.Pose pose) {
            return OptionalInt.of(poses.add(pose.at(), atMillis, line.number()));
        }
        if (line.entry() instanceof LogEntry.Fix fix) {
            return OptionalInt.of(fixes.add(fix.at(), atMillis, line.number()));
        }
        return OptionalInt.empty();
    }

    private void problem(LogLines.Line line, LineFault fault, String message) throws IOException {
        if (firstMessage.isEmpty()) {
            firstMessage = message;
        }
        String text = line.text();
        String kept = text.length() <= TEXT_KEPT ? text : text.substring(0, TEXT_KEPT) + "...";
        LineProblem problem = new LineProblem(line.number(), fault, message, kept);
        problems.add(problem);
        if (tables.isPresent()) {
            tables.get().problem(problem);
        }
    }
}

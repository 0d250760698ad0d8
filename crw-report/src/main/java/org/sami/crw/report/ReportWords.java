package org.sami.crw.report;

import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Optional;

/** What a report's records are in words, as they stand in its text, on its map and in tables. */
public final class ReportWords {
    private ReportWords() {}

    /** Who came how near, when and where. */
    static String words(Approach approach) {
        return String.format(
                Locale.ROOT,
                "%.1f m, %s and %s at %.1f s, %s",
                approach.distanceM(),
                approach.boat(),
                approach.other(),
                approach.atMillis() / 1000.0,
                degrees(approach.where()));
    }

    /** How much of an area was explored, by the best tracks that are known and then by others. */
    static String words(Exploration exploration) {
        Exploration.Left left = exploration.left();
        String reported = left.trueM2().isEmpty()
                ? " by reported positions"
                : left.reportedM2()
                        .filter(m2 -> !left.trueM2().equals(Optional.of(m2)))
                        .map(m2 -> "; by reported positions " + percent(exploration, m2))
                        .orElse("");
        return String.format(
                        Locale.ROOT,
                        "%s of %.0f m², %.0f m² left",
                        percent(exploration, exploration.uncoveredM2()),
                        exploration.areaM2(),
                        exploration.uncoveredM2())
                + reported
                + left.plannedM2()
                        .map(m2 -> "; by the plan " + percent(exploration, m2))
                        .orElse("");
    }

    private static String percent(Exploration exploration, double leftM2) {
        return String.format(Locale.ROOT, "%.2f %%", exploration.percent(leftM2));
    }

    /** When a run began, in UTC and, where that is another time, in the time zone of its machine. */
    public static String moment(RunOrigin origin) {
        DateTimeFormatter form = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm:ss", Locale.ROOT);
        ZonedDateTime utc = origin.startedAt().atZone(ZoneOffset.UTC);
        ZonedDateTime there = origin.startedAt().atZone(origin.zone());
        String zone = origin.zone().getId();
        String local = there.toLocalDateTime().equals(utc.toLocalDateTime()) ? zone : form.format(there) + " " + zone;
        return form.format(utc) + " UTC" + (local.equals("UTC") ? "" : " (" + local + ")");
    }

    /** A position as the command line takes it. */
    static String degrees(MapPoint point) {
        return String.format(Locale.ROOT, "%.7f,%.7f", point.latDeg(), point.lonDeg());
    }

    /** A span of time for people: {@code 45 s}, {@code 7 min 12 s}, {@code 1 h 5 min}. */
    public static String duration(long millis) {
        long seconds = Math.round(millis / 1000.0);
        if (seconds < 60) {
            return seconds + " s";
        }
        if (seconds < 3600) {
            return seconds / 60 + " min " + seconds % 60 + " s";
        }
        return seconds / 3600 + " h " + seconds % 3600 / 60 + " min";
    }
}

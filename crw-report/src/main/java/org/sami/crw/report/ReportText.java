package org.sami.crw.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.sami.crw.report.LocationResult.Truth;

/** The report as text for a terminal. */
public final class ReportText {
    private static final int MOST_PAIRS = 5;
    private static final int NOTES_SHOWN = 10;
    private static final int TASKS_SHOWN = 8;
    private static final int TARGETS_SHOWN = 10;
    private static final String DISCARDED = "discarded";

    private ReportText() {}

    /** The report, with line feeds, about one screen. */
    public static String text(RunReport report) {
        StringBuilder text = new StringBuilder();
        summary(text, report);
        waits(text, report);
        boats(text, report);
        interrupts(text, report);
        tasks(text, report);
        readings(text, report);
        targets(text, report);
        report.parts().forEach(part -> part.lines().forEach(line -> line(text, line)));
        notes(text, report);
        return text.toString();
    }

    private static void summary(StringBuilder text, RunReport report) {
        RunHeader header = report.header();
        RunResult result = report.result();
        line(text, "%s (plan %s), seed %d", header.planName(), header.plan(), header.seed());
        line(text, "  %-20s%s%s", "outcome", result.outcome().word(), reason(result));
        report.problems().forEach(problem -> line(text, "  %-20s%s", "problem", problem.message()));
        report.origin().ifPresent(from -> line(text, "  %-20s%s", "started", ReportWords.moment(from)));
        line(
                text,
                "  %-20s%s (%.1f s)",
                result.outcome() == RunOutcome.ENDED ? "completion time" : "simulated time",
                ReportWords.duration(result.simulatedMillis()),
                result.simulatedMillis() / 1000.0);
        line(text, "  %-20s%.1f s", "wall time", result.wallSeconds());
        line(text, "  %-20s%d", "clicks", result.clicks());
        visits(text, report);
        line(text, "  %-20s%.0f m", "distance", report.distanceM());
        report.map()
                .closest()
                .ever()
                .ifPresent(ever -> line(text, "  %-20s%s", "closest approach", ReportWords.words(ever)));
        report.map()
                .closest()
                .underWay()
                .filter(underWay -> !report.map().closest().ever().equals(Optional.of(underWay)))
                .ifPresent(underWay -> line(text, "  %-20s%s", "  under way", ReportWords.words(underWay)));
        near(text, report);
        report.map()
                .explorations()
                .forEach(explored -> line(text, "  %-20s%s", "explored", ReportWords.words(explored)));
        line(text, "  %-20s%d", "firings", result.firings());
        long answered =
                report.decisions().stream().filter(DecisionResult::answered).count();
        line(
                text,
                "  %-20s%d of %d answered",
                "decisions",
                answered,
                report.decisions().size());
        result.resumedFrom().ifPresent(from -> line(text, "  %-20sjournal entry %d", "resumed from", from));
        line(text, "  %-20s%s", "centre", ReportWords.degrees(header.place().centre()));
        header.place()
                .quay()
                .ifPresent(quay -> line(text, "  %-20s%s", header.robots().say("quay"), ReportWords.degrees(quay)));
        report.origin().ifPresent(from -> line(text, "  %-20scrw %s", "program", from.version()));
        line(text, "  %-20s%s", "plan hash", header.planHash());
        line(text, "  %-20s%s", "run hash", result.runHash());
    }

    /** What boats reported, and under it, where that is known, where they truly were. */
    private static void visits(StringBuilder text, RunReport report) {
        int count = report.locations().size();
        if (count == 0) {
            return; // a mission of tasks or areas, not of locations
        }
        String told = report.header().robots().say(", as boats reported");
        line(text, "  %-20s%d of %d%s", "locations visited", report.locationsReported(), count, told);
        List<Truth> truths = report.locations().stream()
                .flatMap(location -> location.truth().stream())
                .toList();
        if (truths.isEmpty()) {
            return;
        }
        long far = truths.stream().filter(truth -> truth.nearestM().isEmpty()).count();
        String unmeasured =
                far == 0 ? "" : ", " + far + report.header().robots().say(" where no boat came near");
        String farthest = truths.stream()
                .flatMapToDouble(truth -> truth.nearestM().stream())
                .boxed()
                .max(Comparator.naturalOrder())
                .map(nearest -> String.format(Locale.ROOT, ", farthest %.1f m", nearest))
                .orElse("");
        line(
                text,
                "  %-20s%d of %d%s%s",
                String.format(Locale.ROOT, "  truly within %.0f m", Truth.RADIUS_M),
                report.locationsVisited(),
                count,
                farthest,
                unmeasured);
    }

    /** The pairs of boats that came too near to one another, the first few of them. */
    private static void near(StringBuilder text, RunReport report) {
        List<Approach> pairs = report.map().closest().near();
        if (pairs.isEmpty()) {
            return;
        }
        String label = String.format(Locale.ROOT, "  under %.0f m", ClosestApproach.NEAR_M);
        String of = report.header().robots().say(pairs.size() == 1 ? "pair of boats" : "pairs of boats");
        line(text, "  %-20s%d %s", label, pairs.size(), of);
        pairs.stream().limit(MOST_PAIRS).forEach(pair -> line(text, "  %-20s%s", "", ReportWords.words(pair)));
        if (pairs.size() > MOST_PAIRS) {
            line(text, "  %-20s%d more in approaches.csv", "", pairs.size() - MOST_PAIRS);
        }
    }

    private static String reason(RunResult result) {
        return result.reason().isEmpty() ? "" : ": " + result.reason();
    }

    /** Where the mission stood, and why it went no further. */
    private static void waits(StringBuilder text, RunReport report) {
        if (!report.waits().isEmpty()) {
            line(text, "");
            line(text, "  where the mission stood");
            report.waits().forEach(wait -> wait.lines().forEach(line -> line(text, "  %s", line)));
        }
    }

    private static void boats(StringBuilder text, RunReport report) {
        line(text, "");
        line(
                text,
                "  %-12s%12s%12s%12s   %s",
                report.header().robots().word(),
                "distance",
                "battery",
                "recharges",
                "link");
        for (BoatResult boat : report.boats()) {
            line(
                    text,
                    "  %-12s%10.0f m%10.1f %%%12d   %s",
                    boat.id(),
                    boat.distanceM(),
                    boat.batteryPercent(),
                    boat.recharges(),
                    link(boat.link()));
        }
        if (report.result().outcome() != RunOutcome.ENDED) {
            whys(text, report);
        }
    }

    private static String link(LinkResult link) {
        if (link.lost() == 0) {
            return link.words();
        }
        String back = link.reconnected() == link.lost() ? "" : ", back " + link.reconnected() + " x";
        return link.words() + ", lost " + link.lost() + " x" + back;
    }

    /** Why each boat moved or did not when the run stopped. */
    private static void whys(StringBuilder text, RunReport report) {
        List<String> whys = report.boats().stream()
                .map(boat -> boat.link().why())
                .filter(why -> !why.isEmpty())
                .toList();
        if (!whys.isEmpty()) {
            line(text, "");
            line(text, report.header().robots().say("  boats when the run stopped"));
            whys.forEach(why -> line(text, "  %s", report.header().robots().say(why)));
        }
    }

    private static void interrupts(StringBuilder text, RunReport report) {
        if (report.interrupts().isEmpty()) {
            return;
        }
        line(text, "");
        line(text, "  interrupts");
        for (InterruptResult interrupt : report.interrupts()) {
            String boat = interrupt.boat().isEmpty() ? "" : " for " + interrupt.boat();
            line(text, "  %s%s: %s", interrupt.name(), boat, pressed(interrupt));
        }
    }

    private static String pressed(InterruptResult interrupt) {
        if (interrupt.pressedAtMillis().isEmpty()) {
            return "not pressed, for the run was over before";
        }
        String first = String.format(
                Locale.ROOT, "pressed at %.1f s", interrupt.pressedAtMillis().getAsLong() / 1000.0);
        String more = interrupt.presses() > 1 ? ", " + interrupt.presses() + " times in all" : "";
        String taken = interrupt.taken()
                ? String.format(
                        Locale.ROOT,
                        ", taken at %.1f s",
                        interrupt.takenAtMillis().getAsLong() / 1000.0)
                : ", never taken";
        return first + more + taken;
    }

    /** For each boat its tasks in the order in which it began with them; then those that nobody has. */
    private static void tasks(StringBuilder text, RunReport report) {
        if (report.tasks().isEmpty()) {
            return;
        }
        Map<String, List<TaskResult>> byBoat = new TreeMap<>();
        report.tasks().stream()
                .sorted(Comparator.comparingLong(task -> task.startedAtMillis().orElse(Long.MAX_VALUE)))
                .forEach(task -> byBoat.computeIfAbsent(task.boat(), boat -> new ArrayList<>())
                        .add(task));
        long complete = report.tasks().stream().filter(TaskResult::isComplete).count();
        line(text, "");
        line(text, "  tasks: %d of %d complete", complete, report.tasks().size());
        List<TaskResult> nobodys = byBoat.remove("");
        byBoat.forEach((boat, tasks) -> line(text, "  %-12s%s", boat, words(tasks)));
        if (nobodys != null) {
            line(text, "  %-12s%s", "nobody", words(nobodys));
        }
    }

    private static String words(List<TaskResult> tasks) {
        String words = tasks.stream()
                .limit(TASKS_SHOWN)
                .map(task -> task.task() + (task.isComplete() ? "" : " (not complete)"))
                .collect(Collectors.joining(", "));
        int more = tasks.size() - TASKS_SHOWN;
        return more > 0 ? words + " and " + more + " more" : words;
    }

    private static void readings(StringBuilder text, RunReport report) {
        List<ReadingSummary> channels = ReadingSummary.of(report.readings());
        if (channels.isEmpty()) {
            return;
        }
        line(text, "");
        line(text, "  %-20s%10s%12s%12s%12s   %s", "readings", "count", "least", "mean", "most", "unit");
        for (ReadingSummary channel : channels) {
            line(
                    text,
                    "  %-20s%10d%12.2f%12.2f%12.2f   %s",
                    channel.sensor() + " " + channel.channel(),
                    channel.count(),
                    channel.least(),
                    channel.mean(),
                    channel.most(),
                    channel.unit());
        }
    }

    private static void targets(StringBuilder text, RunReport report) {
        List<TargetSummary> targets = TargetSummary.of(report.readings());
        if (targets.isEmpty()) {
            return;
        }
        line(text, "");
        line(text, "  %-10s%10s%12s   %-25sby", "targets", "reported", "first at", "place");
        targets.stream()
                .limit(TARGETS_SHOWN)
                .forEach(target -> line(
                        text,
                        "  %-10d%10d%10.1f s   %-25s%s",
                        target.number(),
                        target.count(),
                        target.firstAtMillis() / 1000.0,
                        String.format(Locale.ROOT, "%.7f,%.7f", target.latDeg(), target.lonDeg()),
                        String.join(", ", target.boats())));
        if (targets.size() > TARGETS_SHOWN) {
            line(text, "  and %d more (report.json)", targets.size() - TARGETS_SHOWN);
        }
    }

    /** Answers without a transition are counted; news that no transition awaits is left out, problems were named. */
    private static void notes(StringBuilder text, RunReport report) {
        List<NoteResult> shown = report.notes().stream()
                .filter(note ->
                        !note.kind().equals(DISCARDED) && !note.kind().equals(NoteResult.NEWS) && !note.isProblem())
                .toList();
        long discarded = report.notes().stream()
                .filter(note -> note.kind().equals(DISCARDED))
                .count();
        if (shown.isEmpty() && discarded == 0) {
            return;
        }
        line(text, "");
        line(text, "  notes");
        shown.stream().limit(NOTES_SHOWN).forEach(note -> {
            line(text, "  %8.1f s  %-18s%s", note.atMillis() / 1000.0, note.kind(), note.message());
        });
        if (shown.size() > NOTES_SHOWN) {
            line(text, "  and %d more (report.json)", shown.size() - NOTES_SHOWN);
        }
        if (discarded > 0) {
            line(
                    text,
                    "  %d %s discarded, for no transition waited for %s any longer (report.json)",
                    discarded,
                    discarded == 1 ? "answer was" : "answers were",
                    discarded == 1 ? "it" : "them");
        }
    }

    private static void line(StringBuilder text, String format, Object... values) {
        text.append(values.length == 0 ? format : String.format(Locale.ROOT, format, values))
                .append('\n');
    }
}

package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The first difference between what was seen of a learner's plan and of the solution. What happens after the earlier end of two runs that
 * went on is not compared.
 */
final class TraceDifference {
    private final JobCase job;
    private final CaseRun run;
    private final CaseRun right;
    private final TraceWords words;

    TraceDifference(JobCase job, CaseRun run, CaseRun right, TraceWords words) {
        this.job = job;
        this.run = run;
        this.right = right;
        this.words = words;
    }

    /** In a sentence; empty where there is none. */
    Optional<String> sentence() {
        if (run.end() == CaseRun.End.REFUSED) {
            return right.end() == CaseRun.End.REFUSED
                    ? Optional.empty()
                    : say("the plan cannot start: " + run.refusal());
        }
        boolean bothGoOn = goesOn(run) && goesOn(right);
        long until = bothGoOn ? Math.min(run.endMillis(), right.endMillis()) : Long.MAX_VALUE;
        List<TraceItem> seen = upTo(until, run.watched(job.watch()));
        List<TraceItem> wanted = upTo(until, right.watched(job.watch()));
        List<TraceItem> missing = without(wanted, seen);
        List<TraceItem> extra = without(seen, wanted);
        long first = Math.min(firstTime(missing), firstTime(extra));
        Optional<String> end = bothGoOn ? Optional.empty() : end(first);
        if (end.isPresent()) {
            return end;
        }
        if (first == Long.MAX_VALUE) {
            return Optional.empty();
        }
        Optional<TraceItem> isMissing = at(first, missing);
        return isMissing.isPresent()
                ? missing(isMissing.get(), seen, extra)
                : extra(at(first, extra).orElseThrow(), wanted);
    }

    private static boolean goesOn(CaseRun run) {
        return run.end() == CaseRun.End.GOES_ON || run.end() == CaseRun.End.ENDLESS;
    }

    private Optional<String> say(String what) {
        return Optional.of(job.words() + ", " + what + ".");
    }

    /** How the missions end otherwise, where that comes before everything else that differs; else where nothing else does. */
    private Optional<String> end(long first) {
        boolean sameEnd = run.end() == right.end() && (!run.hasEnded() || run.endMillis() == right.endMillis());
        if (sameEnd) {
            return Optional.empty();
        }
        if (run.end() == CaseRun.End.ENDLESS) {
            return say("the plan never comes to rest: " + run.refusal());
        }
        if (run.hasEnded() && run.endMillis() < first) {
            String ends = run.end() == CaseRun.End.ABORTED ? "is aborted " : "ends ";
            return say("the mission " + ends
                    + (right.hasEnded() && right.endMillis() > run.endMillis() ? "already " : "")
                    + TraceWords.at(run.endMillis()) + "; with a right plan it " + rightEnd());
        }
        if (!run.hasEnded() && first == Long.MAX_VALUE) {
            return say(
                    right.hasEnded()
                            ? "the mission never ends; with a right plan it ends " + TraceWords.at(right.endMillis())
                            : run.end() == CaseRun.End.WAITS
                                    ? "the plan comes to a halt " + TraceWords.at(run.endMillis())
                                            + "; a right plan goes on"
                                    : "the plan goes on and on; with a right plan it comes to rest");
        }
        return run.hasEnded() && first == Long.MAX_VALUE
                ? say("the mission ends " + TraceWords.at(run.endMillis()) + "; with a right plan it " + rightEnd())
                : Optional.empty();
    }

    private String rightEnd() {
        return right.end() == CaseRun.End.ABORTED
                ? "is aborted " + TraceWords.at(right.endMillis())
                : right.hasEnded() ? "ends " + TraceWords.at(right.endMillis()) : "goes on";
    }

    private Optional<String> missing(TraceItem item, List<TraceItem> seen, List<TraceItem> extra) {
        Optional<TraceItem> otherValues = extra.stream()
                .filter(other -> other.atMillis() == item.atMillis() && other.isLike(item))
                .findFirst();
        if (otherValues.isPresent()) {
            return say(TraceWords.at(item.atMillis()) + " " + words.what(item) + " has another value in "
                    + words.differing(item, otherValues.get()) + " than with a right plan");
        }
        Optional<TraceItem> later = seen.stream()
                .filter(other -> other.atMillis() > item.atMillis() && other.isLike(item))
                .findFirst();
        return say(words.what(item)
                + later.map(other -> " happens only " + TraceWords.at(other.atMillis()) + ", with a right plan "
                                + TraceWords.at(item.atMillis()))
                        .orElse(" does not happen " + TraceWords.at(item.atMillis()) + "; with a right plan it does"));
    }

    private Optional<String> extra(TraceItem item, List<TraceItem> wanted) {
        Optional<TraceItem> later = wanted.stream()
                .filter(other -> other.atMillis() > item.atMillis() && other.isLike(item))
                .findFirst();
        return say(words.what(item) + " happens "
                + later.map(other -> "already " + TraceWords.at(item.atMillis()) + ", with a right plan only "
                                + TraceWords.at(other.atMillis()))
                        .orElse(TraceWords.at(item.atMillis()) + "; with a right plan it does not"));
    }

    private static List<TraceItem> upTo(long until, List<TraceItem> items) {
        return items.stream().filter(item -> item.atMillis() <= until).toList();
    }

    private static List<TraceItem> without(List<TraceItem> items, List<TraceItem> others) {
        List<TraceItem> left = new ArrayList<>(items);
        others.forEach(left::remove);
        return left;
    }

    private static long firstTime(List<TraceItem> items) {
        return items.isEmpty() ? Long.MAX_VALUE : items.get(0).atMillis();
    }

    private static Optional<TraceItem> at(long time, List<TraceItem> items) {
        return items.stream().filter(item -> item.atMillis() == time).findFirst();
    }
}

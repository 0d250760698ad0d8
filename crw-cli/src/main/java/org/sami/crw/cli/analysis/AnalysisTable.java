package org.sami.crw.cli.analysis;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.sami.crw.cli.output.ExitCode;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.spn.planspace.PlanQueryAnswer;
import org.sami.spn.planspace.PlanQueryAnswer.Result;

/** Prints the rows of a table in Markdown as they come, below it what is not as it should be with the runs that show it. */
final class AnalysisTable {
    private final PrintWriter out;
    private final List<String> notes = new ArrayList<>();
    private boolean hasFault;
    private boolean isOpen;
    private int rows;
    private long nanos;

    AnalysisTable(PrintWriter out) {
        this.out = out;
    }

    void begin() {
        out.println(
                "| plan | boats | places, transitions of its net | states | stops before its end | every run can end |"
                        + " its queries | never fires | seconds |");
        out.println("|---|---|---|---|---|---|---|---|---|");
    }

    void add(AnalysedPlans.Row row) {
        rows++;
        nanos += row.nanos();
        String cells = row.found().map(found -> cells(row, found)).orElse("too large | – | – | – | – | –");
        if (row.found().isEmpty()) {
            isOpen = true;
            notes.add(row.plan().id() + ": " + row.refusal());
        }
        out.printf(Locale.ROOT, "| `%s` | %d | %s | %.2f |%n", row.plan().id(), row.boats(), cells, row.nanos() / 1e9);
        out.flush();
    }

    private String cells(AnalysedPlans.Row row, AnalysedPlans.Found found) {
        isOpen |= !found.facts().graph().isComplete();
        List<PlanQueryAnswer> all = new ArrayList<>(List.of(found.stops(), found.ends()));
        all.addAll(found.saved());
        for (PlanQueryAnswer answer : all) {
            hasFault |= answer.result() == Result.UNEXPECTED || answer.result() == Result.FAULT;
            isOpen |= answer.result() == Result.OPEN && !answer.mayBe();
            if (answer.result() != Result.EXPECTED) {
                note(row, answer);
            }
        }
        return "%d, %d | %d%s | %s | %s | %s | %s"
                .formatted(
                        found.net().net().placeCount(),
                        found.net().net().transitionCount(),
                        found.facts().graph().states(),
                        !found.facts().graph().isComplete()
                                ? " and more"
                                : (found.facts().gathering().isEmpty() ? "" : "*")
                                        + (found.net().isPresent() ? "†" : ""),
                        word(found.stops()),
                        word(found.ends()),
                        saved(found.saved()),
                        found.never().isEmpty() ? "–" : String.join(", ", found.never()));
    }

    private static String word(PlanQueryAnswer answer) {
        String verdict = answer.verdict().name().toLowerCase(Locale.ROOT);
        return answer.mayBe()
                ? verdict + ", not certain"
                : answer.verdict() == NetVerdict.UNKNOWN ? "unknown" : verdict;
    }

    private static String saved(List<PlanQueryAnswer> saved) {
        long met = saved.stream()
                .filter(answer -> answer.result() == Result.EXPECTED)
                .count();
        return saved.isEmpty() ? "–" : met + " of " + saved.size() + " as expected";
    }

    private void note(AnalysedPlans.Row row, PlanQueryAnswer answer) {
        notes.add(
                row.plan().id() + " with " + row.boats() + ", " + answer.query().text() + ": " + answer.words());
        answer.witness().ifPresent(witness -> {
            witness.words().forEach(firing -> notes.add("    " + firing));
            notes.add("    then " + String.join("; ", witness.endWords()));
        });
    }

    /** What is not as it should be, and how long all took. */
    void end() {
        out.println();
        notes.forEach(out::println);
        out.printf(Locale.ROOT, "%d rows in %.1f s%n", rows, nanos / 1e9);
    }

    int exitCode() {
        return hasFault ? ExitCode.FINDINGS : isOpen ? ExitCode.RUNNING : ExitCode.OK;
    }
}

package org.sami.crw.cli.plan;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.math.BigDecimal;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.statespace.DeepCheck;
import org.sami.spn.statespace.DeepChecks;
import org.sami.spn.statespace.DeepFinding;
import org.sami.spn.statespace.DeepRequest;
import org.sami.spn.statespace.DeepResult;
import org.sami.spn.statespace.SearchWatch;
import org.sami.spn.stepping.StepText;
import org.sami.spn.vocabulary.Vocabulary;

/** Searches the plans of a project as DREAMM does by <em>Search deeper</em>, and says what was found. */
final class PlanSearches {
    private static final DeepCheck EVERYTHING = DeepChecks.ALL.get(0);

    private final List<Search> done = new ArrayList<>();
    private final SavedQueries queries;

    /** @param depth how many levels of sub-missions the nets follow, of which queries are asked */
    PlanSearches(int depth) {
        queries = new SavedQueries(depth);
    }

    /** @param cutAfter how long was searched, where that was not enough */
    private record Search(Plan plan, DeepResult result, StepText words, Optional<Duration> cutAfter) {
        String summary() {
            return cutAfter.map(time -> "bounded search only, as " + seconds(time) + " s were used up. ")
                            .orElse("")
                    + result.summary();
        }

        private static String seconds(Duration time) {
            return BigDecimal.valueOf(time.toMillis(), 3).stripTrailingZeros().toPlainString();
        }
    }

    /**
     * Searches one plan after the other; those with errors are left out.
     *
     * @param time how long the search of each plan on the engine may take, and each search for an answer to a saved query
     * @param isStopped asked now and then whether to stop; what was found until then is kept
     */
    void run(
            Project project,
            Vocabulary vocabulary,
            int robots,
            int mostStates,
            Duration time,
            ProgressDisplay progress,
            BooleanSupplier isStopped) {
        List<String> names =
                IntStream.rangeClosed(1, robots).mapToObj(i -> "robot-" + i).toList();
        for (Plan plan : project.plans()) {
            boolean isSound =
                    PlanChecks.check(project, vocabulary, plan.id()).stream().noneMatch(Finding::isError);
            if (isSound && !plan.places().isEmpty() && !isStopped.getAsBoolean()) {
                DeepRequest request = new DeepRequest(project, vocabulary, plan.id(), names, mostStates);
                done.add(search(plan, request, time, progress, isStopped));
                progress.end();
                queries.run(project, vocabulary, plan, names, time, progress, isStopped);
            }
        }
    }

    private static Search search(
            Plan plan, DeepRequest request, Duration time, ProgressDisplay progress, BooleanSupplier isStopped) {
        long begin = System.nanoTime();
        AtomicBoolean isCut = new AtomicBoolean();
        SearchWatch watch = new SearchWatch() {
            @Override
            public void looked(int states, int waiting) {
                progress.show(() -> plan.id() + ": " + states + " states looked at, " + waiting + " known and waiting");
            }

            @Override
            public boolean isCancelled() {
                if (System.nanoTime() - begin >= time.toNanos()) {
                    isCut.set(true);
                }
                return isCut.get() || isStopped.getAsBoolean();
            }
        };
        DeepResult result = EVERYTHING.run(request, watch);
        return new Search(
                plan,
                result,
                StepText.of(request.project(), plan.id(), request.vocabulary()),
                isCut.get() ? Optional.of(time) : Optional.empty());
    }

    /** Whether something was found that is more than a note. */
    boolean haveFound() {
        return queries.haveFound()
                || done.stream()
                        .flatMap(search -> search.result().findings().stream())
                        .anyMatch(found -> found.finding().severity() != Severity.NOTE);
    }

    /**
     * Findings as those of other checks, each with the run that shows it, and a line for each plan.
     *
     * @param explained whether each says why it matters and how it is mended
     */
    void print(PrintWriter out, String source, boolean explained) {
        for (Search search : done) {
            for (DeepFinding found : search.result().findings()) {
                if (explained) {
                    FindingsText.printExplained(out, source, List.of(found.finding()));
                } else {
                    FindingsText.print(out, source, List.of(found.finding()));
                }
                steps(found, search.words()).forEach(step -> out.println("    " + step));
            }
            out.printf("%s: %s%n", search.plan().id(), search.summary());
        }
        queries.print(out);
    }

    /** Puts an array {@code deep} into an object, with one object for each plan, and an array {@code queries}. */
    void put(ObjectNode object, String source) {
        queries.put(object);
        ArrayNode plans = object.putArray("deep");
        for (Search search : done) {
            List<DeepFinding> findings = search.result().findings();
            ObjectNode node = FindingsText.json(
                    source, findings.stream().map(DeepFinding::finding).toList());
            node.put("plan", search.plan().id());
            node.put("states", search.result().states());
            node.put("complete", search.result().complete());
            node.put("summary", search.summary());
            node.put("timeUsedUp", search.cutAfter().isPresent());
            for (int i = 0; i < findings.size(); i++) {
                ArrayNode run = ((ObjectNode) node.get("findings").get(i)).putArray("run");
                steps(findings.get(i), search.words()).forEach(run::add);
            }
            plans.add(node);
        }
    }

    private static List<String> steps(DeepFinding found, StepText words) {
        return found.witness().stream()
                .flatMap(witness -> witness.steps().stream())
                .map(words::of)
                .toList();
    }
}

package org.sami.crw.cli.plan;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
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
    private final SavedQueries queries = new SavedQueries();

    private record Search(Plan plan, DeepResult result, StepText words) {}

    /**
     * Searches one plan after the other; those with errors are left out.
     *
     * @param queryTime how long each search for an answer to a saved query may take
     * @param isStopped asked now and then whether to stop; what was found until then is kept
     */
    void run(
            Project project,
            Vocabulary vocabulary,
            int robots,
            int mostStates,
            Duration queryTime,
            ProgressDisplay progress,
            BooleanSupplier isStopped) {
        List<String> names =
                IntStream.rangeClosed(1, robots).mapToObj(i -> "robot-" + i).toList();
        for (Plan plan : project.plans()) {
            boolean isSound =
                    PlanChecks.check(project, vocabulary, plan.id()).stream().noneMatch(Finding::isError);
            if (isSound && !plan.places().isEmpty() && !isStopped.getAsBoolean()) {
                DeepRequest request = new DeepRequest(project, vocabulary, plan.id(), names, mostStates);
                done.add(new Search(
                        plan,
                        EVERYTHING.run(request, watch(plan, progress, isStopped)),
                        StepText.of(project, plan.id(), vocabulary)));
                progress.end();
                queries.run(project, vocabulary, plan, names, queryTime, progress, isStopped);
            }
        }
    }

    private static SearchWatch watch(Plan plan, ProgressDisplay progress, BooleanSupplier isStopped) {
        return new SearchWatch() {
            @Override
            public void looked(int states, int waiting) {
                progress.show(() -> plan.id() + ": " + states + " states looked at, " + waiting + " known and waiting");
            }

            @Override
            public boolean isCancelled() {
                return isStopped.getAsBoolean();
            }
        };
    }

    /** Whether something was found that is more than a note. */
    boolean haveFound() {
        return queries.haveFound()
                || done.stream()
                        .flatMap(search -> search.result().findings().stream())
                        .anyMatch(found -> found.finding().severity() != Severity.NOTE);
    }

    /** Findings as those of other checks, each with the run that shows it, and a line for each plan. */
    void print(PrintWriter out, String source) {
        for (Search search : done) {
            for (DeepFinding found : search.result().findings()) {
                FindingsText.print(out, source, List.of(found.finding()));
                steps(found, search.words()).forEach(step -> out.println("    " + step));
            }
            out.printf("%s: %s%n", search.plan().id(), search.result().summary());
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
            node.put("summary", search.result().summary());
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

package org.sami.crw.cli.plan;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.suggestion.EdgeSuggestions;
import org.sami.spn.suggestion.Suggestion;
import org.sami.spn.suggestion.SuggestionRequest;
import org.sami.spn.suggestion.SuggestionResult;
import org.sami.spn.suggestion.SuggestionWatch;
import org.sami.spn.vocabulary.Vocabulary;

/** The requirements that {@code crw check --suggest} suggests at an edge, as text and as JSON. */
final class RequirementSuggestions {
    private static final int MOST_PRINTED = 8;

    private final String edge;
    private final SuggestionResult result;

    private RequirementSuggestions(String edge, SuggestionResult result) {
        this.edge = edge;
        this.result = result;
    }

    /**
     * Searches at the first edge of that id among a project's plans.
     *
     * @param isStopped asked now and then whether to stop; what was found until then is kept
     * @throws UsageFault if no plan has such an edge, it is locked, or its plan cannot start
     */
    static RequirementSuggestions find(
            Project project, Vocabulary vocabulary, String edge, ProgressDisplay progress, BooleanSupplier isStopped) {
        Plan plan = project.plans().stream()
                .filter(one -> edges(one).anyMatch(edge::equals))
                .findFirst()
                .orElseThrow(() -> new UsageFault("there is no edge \"" + edge + "\"; there are "
                        + String.join(
                                ", ",
                                project.plans().stream()
                                        .flatMap(RequirementSuggestions::edges)
                                        .distinct()
                                        .toList())));
        SuggestionWatch watch = new SuggestionWatch() {
            @Override
            public void tried(int candidates, int all) {
                progress.show(() -> edge + ": " + candidates + " of " + all + " sets of requirements tried");
            }

            @Override
            public boolean isCancelled() {
                return isStopped.getAsBoolean();
            }
        };
        try {
            return new RequirementSuggestions(
                    edge, EdgeSuggestions.find(new SuggestionRequest(project, vocabulary, plan.id(), edge), watch));
        } catch (IllegalArgumentException refused) {
            throw new UsageFault(String.valueOf(refused.getMessage()));
        } finally {
            progress.end();
        }
    }

    private static Stream<String> edges(Plan plan) {
        return Stream.concat(
                plan.inEdges().stream().map(in -> in.id()),
                plan.outEdges().stream().map(out -> out.id()));
    }

    /** The best suggestions with what each changes, then one line about the search. */
    void print(PrintWriter out) {
        List<Suggestion> found = result.suggestions();
        for (int i = 0; i < Math.min(MOST_PRINTED, found.size()); i++) {
            Suggestion suggestion = found.get(i);
            out.printf("%s: %d. %s (%s)%n", edge, i + 1, suggestion.words(), suggestion.balance());
            suggestion.mended().forEach(line -> out.println("    + " + line));
            suggestion.caused().forEach(line -> out.println("    - " + line));
        }
        out.printf("%s: %s; %d states were looked at%n", edge, result.summary(), result.states());
    }

    /** Puts an object {@code suggestions} into an object, with all of them. */
    void put(ObjectNode object) {
        ObjectNode node = object.putObject("suggestions")
                .put("edge", edge)
                .put("findings", result.findings())
                .put("tried", result.tried())
                .put("candidates", result.candidates())
                .put("states", result.states())
                .put("summary", result.summary());
        ArrayNode list = node.putArray("list");
        for (Suggestion suggestion : result.suggestions()) {
            ObjectNode one = list.addObject()
                    .put("requirements", suggestion.words())
                    .put("left", suggestion.left())
                    .put("complete", suggestion.complete());
            suggestion.mended().forEach(one.putArray("mended")::add);
            suggestion.caused().forEach(one.putArray("caused")::add);
        }
    }
}

package org.sami.crw.cli.plan;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.spn.model.Plan;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.PlanQueries;
import org.sami.spn.planspace.PlanQueryAnswer;
import org.sami.spn.planspace.PlanQueryAnswer.Result;
import org.sami.spn.planspace.PlanWitness;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Answers the queries that are saved with the plans of a project, by searches of their nets, and says what came of each. A plan without any is asked whether it stops before its end, and whether
 * every run can end: what is certain then is a proof, where the search on the engine only tries values.
 */
final class SavedQueries {
    private static final List<PlanQuery> USUAL = List.of(
            new PlanQuery("it stops before its end", "deadlock", PlanQuery.Expected.NO),
            new PlanQuery("every run can end", "home ended", PlanQuery.Expected.YES));

    private final List<Answered> answers = new ArrayList<>();

    private final int depth;

    /** @param depth how many levels of sub-missions the nets follow */
    SavedQueries(int depth) {
        this.depth = depth;
    }

    private record Answered(Plan plan, PlanQueryAnswer answer) {}

    /** Answers the queries of a plan, or the usual ones where it has none. Where its net is too large, each of them stays open. */
    void run(
            Project project,
            Vocabulary vocabulary,
            Plan plan,
            List<String> robots,
            Duration time,
            ProgressDisplay progress,
            BooleanSupplier isStopped) {
        List<PlanQuery> asked = plan.queries().isEmpty() ? USUAL : plan.queries();
        SearchBudget budget =
                new SearchBudget(SearchBudget.MOST_STATES, Runtime.getRuntime().maxMemory() / 2, time);
        try {
            PlanNet net = PlanNet.smallest(new PlanNetRequest(project, vocabulary, plan.id(), robots).toDepth(depth));
            PlanQueries queries = new PlanQueries(net, budget, watch(plan, progress, isStopped));
            asked.forEach(query -> add(plan, queries.answer(query)));
        } catch (PlanNetTooLargeException tooLarge) {
            asked.forEach(query -> add(plan, open(query, tooLarge)));
        }
        progress.end();
    }

    /** An answer that is not certain is left out where nobody asked: the search on the engine has said what it saw. */
    private void add(Plan plan, PlanQueryAnswer answer) {
        if (!plan.queries().isEmpty() || answer.result() != Result.OPEN) {
            answers.add(new Answered(plan, answer));
        }
    }

    private static PlanQueryAnswer open(PlanQuery query, PlanNetTooLargeException tooLarge) {
        return PlanQueryAnswer.without(query, Result.OPEN, "unknown: " + tooLarge.getMessage());
    }

    private static GraphWatch watch(Plan plan, ProgressDisplay progress, BooleanSupplier isStopped) {
        return new GraphWatch() {
            @Override
            public void looked(int states, int waiting) {
                progress.show(() ->
                        plan.id() + ": " + states + " states of its net looked at, " + waiting + " known and waiting");
            }

            @Override
            public boolean isCancelled() {
                return isStopped.getAsBoolean();
            }
        };
    }

    /** Whether a query means nothing, or has another answer than the author expects. */
    boolean haveFound() {
        return answers.stream()
                .map(each -> each.answer().result())
                .anyMatch(result -> result == Result.FAULT || result == Result.UNEXPECTED);
    }

    /** A line for each query; below an answer that is not the expected one, the run that shows it. */
    void print(PrintWriter out) {
        for (Answered each : answers) {
            PlanQueryAnswer answer = each.answer();
            out.printf(
                    "%s: query \"%s\" %s: %s%n",
                    each.plan().id(), answer.query().name(), word(answer), answer.words());
            if (answer.result() == Result.UNEXPECTED) {
                answer.witness().ifPresent(witness -> {
                    witness.words().forEach(firing -> out.println("    " + firing));
                    out.println("    then " + words(witness));
                });
            }
        }
    }

    private static String words(PlanWitness witness) {
        return witness.endWords().isEmpty() ? "no token anywhere" : String.join("; ", witness.endWords());
    }

    private static String word(PlanQueryAnswer answer) {
        return switch (answer.result()) {
            case EXPECTED -> "as expected";
            case UNEXPECTED ->
                "NOT AS EXPECTED (" + answer.query().expected().name().toLowerCase(Locale.ROOT) + ")";
            case OPEN -> answer.mayBe() ? "not certain" : "open";
            case FAULT -> "has a fault";
        };
    }

    /** Puts an array {@code queries} into an object, with one object for each query. */
    void put(ObjectNode object) {
        ArrayNode list = object.putArray("queries");
        for (Answered each : answers) {
            PlanQueryAnswer answer = each.answer();
            ObjectNode node = list.addObject()
                    .put("plan", each.plan().id())
                    .put("name", answer.query().name())
                    .put("query", answer.query().text())
                    .put("expect", answer.query().expected().name().toLowerCase(Locale.ROOT))
                    .put("result", answer.result().name().toLowerCase(Locale.ROOT))
                    .put("answer", answer.words());
            answer.witness().ifPresent(witness -> {
                ArrayNode run = node.putArray("run");
                witness.words().forEach(run::add);
                node.put("marking", words(witness));
            });
        }
    }
}

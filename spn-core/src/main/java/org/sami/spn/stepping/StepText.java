package org.sami.spn.stepping;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestStep;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Steps of one plan in a few words, without values. Steps speak of the ids of the plan, or of a sub-mission's below it; the words speak of
 * events by their titles and of vertices by their names. Immutable.
 */
public final class StepText {
    private final Vocabulary vocabulary;
    private final List<Plan> plans;

    private StepText(Vocabulary vocabulary, List<Plan> plans) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        this.plans = List.copyOf(plans);
    }

    /** The words for steps of a plan of a project; ids that neither the plan nor those below it have stay as they are. */
    public static StepText of(Project project, String plan, Vocabulary vocabulary) {
        Set<Plan> below = new LinkedHashSet<>();
        List<String> open = new ArrayList<>(List.of(plan));
        for (int i = 0; i < open.size(); i++) {
            project.plan(open.get(i))
                    .filter(below::add)
                    .ifPresent(found ->
                            found.places().forEach(place -> place.subMissions().forEach(sub -> open.add(sub.plan()))));
        }
        return new StepText(vocabulary, List.copyOf(below));
    }

    /** The words, such as {@code press Stop} or {@code Proxy Path Failed of robot-1, answering Proxy Execute Path at Go}. */
    public String of(TestStep step) {
        if (step instanceof TestStep.Answer s) {
            return "operator: " + reply(s.reply()) + whom(s);
        } else if (step instanceof TestStep.Occur s) {
            List<String> named = new ArrayList<>(s.proxies());
            named.addAll(s.tasks());
            String whom = named.isEmpty() ? "" : " of " + String.join(", ", named);
            return vocabulary.title(s.type())
                    + whom
                    + (s.answers().isEmpty() ? "" : ", answering " + asking(s.answers(), s.type()));
        } else if (step instanceof TestStep.Press s) {
            return "press " + s.interrupt() + (s.proxies().isEmpty() ? "" : " for " + String.join(", ", s.proxies()));
        } else if (step instanceof TestStep.Join s) {
            return s.proxy() + " joins";
        } else if (step instanceof TestStep.Drop s) {
            return "drop " + s.proxy();
        } else if (step instanceof TestStep.Advance s) {
            return s.millis() + " ms pass";
        } else if (step instanceof TestStep.ExpectTokens s) {
            return "expect tokens in " + element(s.place());
        }
        return "expect the end";
    }

    /** Which question an answer answers, after the answer: {@code  to Operator Approves at Ask}, or the start's. */
    public String whom(TestStep.Answer answer) {
        return answer.event().isEmpty() ? " (start)" : " to " + deciding(answer.event());
    }

    /** An output event that is answered by an input event of some type. */
    public String asking(String event, String answeredBy) {
        return event(event, type -> type.answers().contains(answeredBy));
    }

    /** An output event that asks the operator. */
    public String deciding(String event) {
        return event(event, type -> type.decision().isPresent());
    }

    /** What is asked for at a start: {@code speed of Proxy Execute Path at Go} for {@code eventId.field}; a variable as it is called. */
    public String asked(String key) {
        int dot = key.indexOf('.');
        return dot < 0 ? key : key.substring(dot + 1) + " of " + event(key.substring(0, dot), type -> true);
    }

    /** Of several plans that have an event of one id, the first whose event can be meant. */
    private String event(String id, Predicate<EventType> isMeant) {
        return plans.stream()
                .filter(plan -> outputs(plan, id)
                        .map(OutputEventSpec::type)
                        .flatMap(vocabulary::event)
                        .filter(isMeant)
                        .isPresent())
                .findFirst()
                .flatMap(plan -> new ElementNames(plan, vocabulary).of(id))
                .orElseGet(() -> element(id));
    }

    private static Optional<OutputEventSpec> outputs(Plan plan, String id) {
        return plan.places().stream()
                .flatMap(place -> place.outputs().stream())
                .filter(output -> output.id().equals(id))
                .findFirst();
    }

    private String element(String id) {
        return plans.stream()
                .flatMap(plan -> new ElementNames(plan, vocabulary).of(id).stream())
                .findFirst()
                .orElse(id);
    }

    private static String reply(TestStep.Reply reply) {
        if (reply instanceof TestStep.Reply.YesNo r) {
            return r.yes() ? "yes" : "no";
        } else if (reply instanceof TestStep.Reply.Proxies r) {
            return r.proxies().isEmpty() ? "nobody" : String.join(", ", r.proxies());
        } else if (reply instanceof TestStep.Reply.Option r) {
            return "option " + (r.index() + 1);
        }
        return reply instanceof TestStep.Reply.Rejected ? "none of them" : "values";
    }
}

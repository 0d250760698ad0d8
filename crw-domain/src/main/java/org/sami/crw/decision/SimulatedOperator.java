package org.sami.crw.decision;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.Reading;
import org.sami.spn.json.ValueJson;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * A simulated operator. It decides the answers; its host's clock decides when. Rules of an answers file come first. Where none fits, it chooses all
 * boats (or as many as allowed), takes the first option, says yes (except to a {@link DomainQuestion} with another default), keeps defaults, and
 * invents locations from its seed. The same decisions in the same order get the same answers. For one thread.
 */
public final class SimulatedOperator {
    private final Vocabulary vocabulary;
    private final List<CountedRule> rules = new ArrayList<>();
    private final DefaultAnswers defaults;
    private final GeneratedValues madeUp;

    /** An operator with rules and what it does without them. */
    public SimulatedOperator(Vocabulary vocabulary, DefaultAnswers defaults, AnswersFile answers) {
        this.vocabulary = vocabulary;
        this.defaults = defaults;
        madeUp = new GeneratedValues(defaults);
        answers.rules().forEach(rule -> rules.add(new CountedRule(rule)));
    }

    /**
     * The answer to a decision. Called once for each, because rules count decisions.
     *
     * @param plan id of the mission's plan
     * @return neither result nor finding where the operator stays silent; a finding with its place in the answers file where a rule does not fit
     *     the question, or no sensible answer exists
     */
    public Reading<Answer> answer(Decision decision, String plan) {
        List<Finding> findings = new ArrayList<>();
        Optional<AnswerRule> rule = ruleFor(decision, plan);
        if (rule.isPresent() && rule.get().answer().has(AnswerForm.SILENT)) {
            return new Reading<>(Optional.empty(), List.of());
        }
        Optional<Answer> answer = answer(decision, plan, rule, findings);
        return new Reading<>(findings.isEmpty() ? answer : Optional.empty(), findings);
    }

    private Optional<Answer> answer(Decision decision, String plan, Optional<AnswerRule> rule, List<Finding> findings) {
        Question question = decision.question();
        if (question instanceof Question.Approve) {
            boolean unasked = DomainQuestion.of(decision.type())
                    .map(DomainQuestion::simulatedAnswer)
                    .orElse(true);
            return Optional.of(new Answer.YesNo(
                    rule.map(r -> r.answer().path(AnswerForm.YES).asBoolean(true))
                            .orElse(unasked)));
        }
        if (question instanceof Question.ChooseProxies choice
                && DomainQuestion.of(decision.type()).isPresent()) {
            boolean all = rule.map(r -> r.answer().path(AnswerForm.YES).asBoolean(true))
                    .orElseGet(() ->
                            DomainQuestion.of(decision.type()).orElseThrow().simulatedAnswer());
            return Optional.of(new Answer.Proxies(all ? choice.proxies() : List.of()));
        }
        if (question instanceof Question.ChooseProxies choice) {
            return Optional.of(new Answer.Proxies(boats(choice, rule, findings)));
        }
        if (question instanceof Question.ChooseOption choice) {
            return Optional.of(option(choice, rule, findings));
        }
        return Optional.of(fields(decision, (Question.FillIn) question, plan, rule, findings));
    }

    private static List<String> boats(
            Question.ChooseProxies choice, Optional<AnswerRule> rule, List<Finding> findings) {
        int known = choice.proxies().size();
        int most = Math.min(choice.max(), known);
        List<String> chosen = new ArrayList<>();
        Optional<JsonNode> given = rule.map(r -> r.answer().path(AnswerForm.BOATS));
        if (given.isPresent() && given.get().isArray()) {
            given.get().forEach(boat -> addBoat(boat.asText(), choice, chosen, rule, findings));
        } else {
            int count = given.filter(JsonNode::isInt).map(JsonNode::intValue).orElse(most);
            if (count > known) {
                findings.add(finding(rule, count + " boats are wanted, and there are " + known + " to choose from"));
                return chosen;
            }
            chosen.addAll(choice.proxies().subList(0, count));
        }
        if (chosen.size() < choice.min() || chosen.size() > choice.max()) {
            findings.add(finding(
                    rule, "From " + choice.min() + " to " + choice.max() + " boats are to be chosen, not " + chosen));
        }
        return chosen;
    }

    private static void addBoat(
            String boat,
            Question.ChooseProxies choice,
            List<String> chosen,
            Optional<AnswerRule> rule,
            List<Finding> findings) {
        if (!choice.proxies().contains(boat)) {
            findings.add(finding(rule, "The boat \"" + boat + "\" is none of " + choice.proxies()));
        } else if (!chosen.contains(boat)) {
            chosen.add(boat);
        }
    }

    private static Answer option(Question.ChooseOption choice, Optional<AnswerRule> rule, List<Finding> findings) {
        boolean rejects = rule.isPresent() && rule.get().answer().has(AnswerForm.REJECT);
        if (rejects || choice.options().isEmpty()) {
            return new Answer.Rejected();
        }
        int index = rule.map(r -> r.answer().path(AnswerForm.OPTION).asInt()).orElse(0);
        if (index >= choice.options().size()) {
            findings.add(finding(
                    rule,
                    "There is no option " + index + " among " + choice.options().size()));
        }
        return new Answer.Option(index);
    }

    private Answer fields(
            Decision decision,
            Question.FillIn question,
            String plan,
            Optional<AnswerRule> rule,
            List<Finding> findings) {
        Map<String, Value> values = new LinkedHashMap<>();
        for (Question.Item item : question.items()) {
            Optional<Given> given = rule.flatMap(r -> given(r, item)).or(() -> startValue(decision, item, plan));
            Optional<Value> value;
            if (given.isPresent() && item.editable()) {
                value = read(given.get(), item, findings);
            } else {
                value = item.defaultValue().or(() -> proposed(decision, item)).or(() -> madeUp.of(item.type()));
                if (value.isEmpty()) {
                    findings.add(Finding.error(
                            "E-NO-ANSWER", "", "The simulated operator has no value for \"" + item.key() + "\""));
                }
            }
            value.ifPresent(v -> values.put(item.key(), v));
        }
        return new Answer.Fields(values);
    }

    /** What the plan's author proposes, where it can be known (markup Default Location). */
    private Optional<Value> proposed(Decision decision, Question.Item item) {
        boolean atQuay = item.type().equals(ValueType.Simple.POINT)
                && decision.markups().stream()
                        .filter(markup -> markup.type().equals("DefaultLocation"))
                        .flatMap(markup -> markup.option("location").stream())
                        .anyMatch(option -> option instanceof EnumValue value
                                && value.constant().equals("QUAY"));
        return atQuay ? Optional.of(defaults.quay()) : Optional.empty();
    }

    private Optional<Value> read(Given given, Question.Item item, List<Finding> findings) {
        Map<String, NamedType> types = vocabulary.types();
        Reading<Value> reading = ValueJson.read(given.node(), item.type(), types);
        for (Finding f : reading.findings()) {
            findings.add(f.within(given.pointer()));
        }
        return reading.result();
    }

    private static Optional<Given> given(AnswerRule rule, Question.Item item) {
        JsonNode node = rule.answer().path(AnswerForm.VALUES).get(item.key());
        return Optional.ofNullable(node).map(n -> new Given(n, rule.pointer() + "/answer/values/" + item.key()));
    }

    private Optional<Given> startValue(Decision decision, Question.Item item, String plan) {
        if (!decision.type().isEmpty()) {
            return Optional.empty();
        }
        return first(rule -> rule.start() && rule.fitsPlan(plan) && rule.fitsItem(item.key()))
                .map(rule -> new Given(rule.answer().get(AnswerForm.VALUE), rule.pointer() + "/answer/value"));
    }

    private Optional<AnswerRule> ruleFor(Decision decision, String plan) {
        String type = vocabulary.event(decision.type()).map(EventType::name).orElse(decision.type());
        return first(
                rule -> !rule.start() && rule.fitsPlan(plan) && rule.event().equals(type));
    }

    /** The first rule that fits and whose turn it is; all that fit count this time. */
    private Optional<AnswerRule> first(java.util.function.Predicate<AnswerRule> fits) {
        Optional<AnswerRule> found = Optional.empty();
        for (CountedRule counted : rules) {
            if (fits.test(counted.rule) && counted.hasTurn() && found.isEmpty()) {
                found = Optional.of(counted.rule);
            }
        }
        return found;
    }

    private static Finding finding(Optional<AnswerRule> rule, String message) {
        return Finding.error("E-ANSWER", rule.map(r -> r.pointer() + "/answer").orElse(""), message);
    }

    private record Given(JsonNode node, String pointer) {}

    private static final class CountedRule {
        private final AnswerRule rule;
        private int count;

        CountedRule(AnswerRule rule) {
            this.rule = rule;
        }

        boolean hasTurn() {
            count++;
            return rule.nth().isEmpty() || rule.nth().getAsInt() == count;
        }
    }
}

package org.sami.spn.engine.rule;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/** Whether an answer fits its question. */
public final class AnswerCheck {
    private AnswerCheck() {}

    /** Why an answer does not fit; empty where it does. */
    public static Optional<String> wrong(Question question, Answer answer, boolean mayReject, Vocabulary vocabulary) {
        if (question instanceof Question.Approve) {
            return expect(answer instanceof Answer.YesNo, "yes or no", answer);
        }
        if (question instanceof Question.ChooseProxies c) {
            if (answer instanceof Answer.Rejected && mayReject) {
                return Optional.empty();
            }
            return answer instanceof Answer.Proxies p
                    ? wrongChoice(c, p.proxies())
                    : expect(false, "a choice of robots", answer);
        }
        if (question instanceof Question.ChooseOption c) {
            if (answer instanceof Answer.Rejected) {
                return expect(mayReject, "one of the options", answer);
            }
            boolean inRange = answer instanceof Answer.Option o
                    && o.index() >= 0
                    && o.index() < c.options().size();
            return expect(inRange, "an option from 0 to " + (c.options().size() - 1), answer);
        }
        return answer instanceof Answer.Fields f
                ? wrongFields((Question.FillIn) question, f.values(), vocabulary)
                : expect(false, "a value for each field", answer);
    }

    private static Optional<String> expect(boolean fits, String what, Answer given) {
        return fits ? Optional.empty() : Optional.of(what + " is expected, not " + words(given));
    }

    private static String words(Answer answer) {
        if (answer instanceof Answer.YesNo yesNo) {
            return yesNo.yes() ? "yes" : "no";
        }
        if (answer instanceof Answer.Proxies chosen) {
            return "the robots " + chosen.proxies();
        }
        if (answer instanceof Answer.Option option) {
            return "option " + option.index();
        }
        return answer instanceof Answer.Fields fields
                ? "values of " + fields.values().keySet()
                : "a rejection";
    }

    private static Optional<String> wrongChoice(Question.ChooseProxies question, List<String> chosen) {
        for (String robot : chosen) {
            if (!question.proxies().contains(robot)) {
                return Optional.of("'" + robot + "' is not among those to choose from");
            }
        }
        if (new LinkedHashSet<>(chosen).size() < chosen.size()) {
            return Optional.of("a robot is chosen twice");
        }
        if (chosen.size() < question.min() || chosen.size() > question.max()) {
            return Optional.of(chosen.size() + " are chosen, not between " + question.min() + " and " + question.max());
        }
        return Optional.empty();
    }

    private static Optional<String> wrongFields(
            Question.FillIn question, Map<String, Value> values, Vocabulary vocabulary) {
        Map<String, Question.Item> items = new LinkedHashMap<>();
        question.items().forEach(i -> items.put(i.key(), i));
        for (Map.Entry<String, Value> e : values.entrySet()) {
            Question.Item item = items.get(e.getKey());
            if (item == null) {
                return Optional.of("'" + e.getKey() + "' was not asked");
            }
            if (!TypeCheck.accepts(item.type(), e.getValue(), vocabulary.types())) {
                return Optional.of("'" + e.getKey() + "' needs a value of type " + TypeNames.of(item.type()) + ", not "
                        + e.getValue());
            }
            if (!item.editable() && !e.getValue().equals(item.defaultValue().orElse(null))) {
                return Optional.of("'" + e.getKey() + "' is locked");
            }
        }
        for (Question.Item item : question.items()) {
            if (!values.containsKey(item.key()) && item.defaultValue().isEmpty()) {
                return Optional.of("'" + item.key() + "' is missing");
            }
        }
        return Optional.empty();
    }

    /** The values of an answer, with defaults where it says nothing. */
    static Map<String, Value> values(Question.FillIn question, Answer.Fields answer) {
        Map<String, Value> result = new LinkedHashMap<>();
        for (Question.Item item : question.items()) {
            Value given = answer.values().get(item.key());
            result.put(item.key(), given == null ? item.defaultValue().orElseThrow() : given);
        }
        return result;
    }
}

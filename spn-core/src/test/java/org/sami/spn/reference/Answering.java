package org.sami.spn.reference;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.Value;

/** Random answers to questions, and random values of answers' fields. */
final class Answering {
    private final Dice dice;

    Answering(Dice dice) {
        this.dice = dice;
    }

    /** An answer that fits, mostly. */
    Answer any(Question question) {
        boolean yes = dice.chance(65);
        if (question instanceof Question.ChooseOption && dice.chance(25)) {
            return new Answer.Option(2); // there are two
        }
        if (question instanceof Question.ChooseProxies && dice.chance(10)) {
            return new Answer.Rejected(); // whom an interrupt is for may be left open, other choices may not
        }
        if (dice.chance(3)) {
            return new Answer.Proxies(List.of("A", "A"));
        }
        return fitting(
                question, yes, question instanceof Question.ChooseProxies c ? dice.some(c.proxies()) : List.of());
    }

    /** Yes or no, or the named boats where they can be chosen. */
    Answer fitting(Question question, boolean yes, List<String> boats) {
        if (question instanceof Question.Approve) {
            return new Answer.YesNo(yes);
        }
        if (question instanceof Question.ChooseProxies choose) {
            List<String> chosen =
                    choose.proxies().stream().filter(boats::contains).toList();
            return new Answer.Proxies(chosen.isEmpty() ? dice.some(choose.proxies()) : chosen);
        }
        if (question instanceof Question.ChooseOption) {
            return yes ? new Answer.Option(dice.below(2)) : new Answer.Rejected();
        }
        Map<String, Value> values = new LinkedHashMap<>();
        for (Question.Item item : ((Question.FillIn) question).items()) {
            if (item.defaultValue().isEmpty() || dice.chance(60)) {
                values.put(item.key(), new IntegerValue(dice.below(50)));
            }
        }
        return new Answer.Fields(values);
    }

    Map<String, Value> values(String type) {
        return switch (type) {
            case "Provided" -> Map.of("number", new IntegerValue(dice.below(50)));
            case "Done", "Done2", "News", "Other" ->
                dice.chance(80) ? Map.of("value", new IntegerValue(dice.below(50))) : Map.of();
            default -> Map.of();
        };
    }
}

package org.sami.dreamm.tryout;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.stepping.StepText;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.Value;
import org.sami.ui.value.ValueSummary;

/** Steps and what came of them, in words for people. */
final class StepWords {
    private static final int MOST = 4;

    private StepWords() {}

    /** A step that is about to be taken: of answers to what is asked, also what is taken as proposed. */
    static String of(TestStep step, Stepper stepper) {
        if (step instanceof TestStep.Answer s && s.reply() instanceof TestStep.Reply.Values given) {
            return stepper.possible().decisions().stream()
                    .filter(decision -> stepper.eventAsking(decision).equals(s.event()))
                    .map(Decision::question)
                    .filter(Question.FillIn.class::isInstance)
                    .findFirst()
                    .map(asked -> filled((Question.FillIn) asked, given.values()))
                    .map(all -> of(new TestStep.Answer(s.event(), new TestStep.Reply.Values(all)), stepper.words()))
                    .orElseGet(() -> of(step, stepper.words()));
        }
        return of(step, stepper.words());
    }

    private static Map<String, Value> filled(Question.FillIn asked, Map<String, Value> given) {
        Map<String, Value> all = new LinkedHashMap<>();
        for (Question.Item item : asked.items()) {
            Optional.ofNullable(given.get(item.key()))
                    .or(item::defaultValue)
                    .ifPresent(value -> all.put(item.key(), value));
        }
        return all;
    }

    static String of(TestStep step, StepText words) {
        if (step instanceof TestStep.Answer s && s.reply() instanceof TestStep.Reply.Values given) {
            return "operator: " + values(given.values(), words) + words.whom(s);
        }
        return step instanceof TestStep.Advance s
                ? ValueSummary.of(new DurationValue(s.millis())) + " pass"
                : words.of(step);
    }

    /** Values by their fields; of fields with one name also by their events. */
    static String values(Map<String, Value> values, StepText words) {
        List<String> fields = values.keySet().stream().map(StepWords::field).toList();
        return values.isEmpty()
                ? "as proposed"
                : values.entrySet().stream()
                        .map(value -> {
                            String field = field(value.getKey());
                            boolean isAlone = Collections.frequency(fields, field) == 1;
                            return (isAlone ? field : words.asked(value.getKey())) + " = "
                                    + ValueSummary.of(value.getValue());
                        })
                        .collect(Collectors.joining("; "));
    }

    private static String field(String key) {
        return key.substring(key.lastIndexOf('.') + 1);
    }

    /**
     * What a step did: which transitions fired, where tokens are now, how it ended.
     *
     * @param name what the transition of a firing is called
     */
    static String of(List<Effect> effects, Function<Effect.Fired, String> name) {
        List<String> fired = new ArrayList<>();
        List<String> rest = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Fired e) {
                fired.add(name.apply(e));
            } else if (effect instanceof Effect.MissionEnded e) {
                rest.add("mission " + e.mission() + " is over: "
                        + e.outcome().name().toLowerCase(Locale.ROOT));
            } else if (effect instanceof Effect.Noted e) {
                rest.add(e.message());
            }
        }
        List<String> words = new ArrayList<>();
        if (!fired.isEmpty()) {
            words.add("fired " + shortened(fired));
        }
        words.addAll(rest.stream().limit(MOST).toList());
        return words.isEmpty() ? "nothing fired" : String.join("; ", words);
    }

    private static String shortened(List<String> names) {
        String text = names.stream().limit(MOST).collect(Collectors.joining(", "));
        return names.size() > MOST ? text + " and " + (names.size() - MOST) + " more" : text;
    }

    static String tokens(List<Token> tokens) {
        long generic = tokens.stream().filter(Token.GENERIC::equals).count();
        List<String> words = new ArrayList<>();
        if (generic > 0) {
            words.add(generic == 1 ? "generic" : generic + " generic");
        }
        for (Token token : tokens) {
            if (token instanceof Token.Proxy proxy) {
                words.add(proxy.proxy());
            } else if (token instanceof Token.Task task) {
                words.add(task.task().name());
            }
        }
        return String.join(", ", words);
    }
}

package org.sami.dreamm.tryout;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Token;
import org.sami.spn.stepping.StepText;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.Value;
import org.sami.ui.value.ValueSummary;

/** Steps and what came of them, in words for people. */
final class StepWords {
    private static final int MOST = 4;

    private StepWords() {}

    static String of(TestStep step) {
        if (step instanceof TestStep.Answer s && s.reply() instanceof TestStep.Reply.Values given) {
            return "operator: " + values(given.values()) + (s.event().isEmpty() ? " (start)" : " to " + s.event());
        }
        return step instanceof TestStep.Advance s
                ? ValueSummary.of(new DurationValue(s.millis())) + " pass"
                : StepText.of(step);
    }

    static String values(Map<String, Value> values) {
        return values.isEmpty()
                ? "as proposed"
                : values.entrySet().stream()
                        .map(value -> value.getKey() + " = " + ValueSummary.of(value.getValue()))
                        .collect(Collectors.joining("; "));
    }

    /** What a step did: which transitions fired, where tokens are now, how it ended. */
    static String of(List<Effect> effects) {
        List<String> fired = new ArrayList<>();
        List<String> rest = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Fired e) {
                fired.add(e.transition());
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

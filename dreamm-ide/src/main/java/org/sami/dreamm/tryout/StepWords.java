package org.sami.dreamm.tryout;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.Value;
import org.sami.ui.value.ValueSummary;

/** Steps and what came of them, in words for people. */
final class StepWords {
    private static final int MOST = 4;

    private StepWords() {}

    static String of(TestStep step) {
        if (step instanceof TestStep.Answer s) {
            return "operator: " + reply(s.reply()) + (s.event().isEmpty() ? " (start)" : " to " + s.event());
        } else if (step instanceof TestStep.Occur s) {
            List<String> named = new ArrayList<>(s.proxies());
            named.addAll(s.tasks());
            String whom = named.isEmpty() ? "" : " of " + String.join(", ", named);
            return s.type() + whom + (s.answers().isEmpty() ? "" : ", answering " + s.answers());
        } else if (step instanceof TestStep.Press s) {
            return "press " + s.interrupt() + (s.proxies().isEmpty() ? "" : " for " + String.join(", ", s.proxies()));
        } else if (step instanceof TestStep.Join s) {
            return s.proxy() + " joins";
        } else if (step instanceof TestStep.Drop s) {
            return "drop " + s.proxy();
        } else if (step instanceof TestStep.Advance s) {
            return ValueSummary.of(new DurationValue(s.millis())) + " pass";
        } else if (step instanceof TestStep.ExpectTokens s) {
            return "expect tokens in " + s.place();
        }
        return "expect the end";
    }

    private static String reply(TestStep.Reply reply) {
        if (reply instanceof TestStep.Reply.YesNo r) {
            return r.yes() ? "yes" : "no";
        } else if (reply instanceof TestStep.Reply.Proxies r) {
            return r.proxies().isEmpty() ? "nobody" : String.join(", ", r.proxies());
        } else if (reply instanceof TestStep.Reply.Option r) {
            return "option " + (r.index() + 1);
        } else if (reply instanceof TestStep.Reply.Rejected) {
            return "none of them";
        }
        return values(((TestStep.Reply.Values) reply).values());
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

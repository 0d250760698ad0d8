package org.sami.crw.operator;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;

/**
 * The operator's load: clicks, counted as thesis 7.1.1 does (docs/clicks.md has the table). A start, an abort, a completion
 * and an interrupt are one click each; each location, each boat and each confirmation is one; what autonomy answers and what
 * is left at its default is none. Counted from inputs, so a journal gives the same number again. Owned by one thread.
 */
public final class ClickCount {
    private final Map<Long, Question> open = new HashMap<>();
    private final Map<ClickKind, Long> byKind = new EnumMap<>(ClickKind.class);
    private long clicks;

    /** Counts one input that was taken in, with what followed from it. */
    public void count(Input input, List<Effect> effects) {
        long more = wasRefused(input, effects) ? 0 : clicksOf(input);
        if (more > 0) {
            clicks += more;
            byKind.merge(kindOf(input), more, Long::sum);
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionOpened opened) {
                open.put(opened.decision().id(), opened.decision().question());
            } else if (effect instanceof Effect.DecisionClosed closed) {
                open.remove(closed.decision());
            }
        }
    }

    /** A person sees that a button is not there; who presses all the same, again and again, is a simulated operator. */
    private static boolean wasRefused(Input input, List<Effect> effects) {
        return input instanceof Input.Interrupt
                && effects.stream()
                        .anyMatch(effect ->
                                effect instanceof Effect.Noted noted && noted.kind() == NoteKind.INTERRUPT_REFUSED)
                && effects.stream()
                        .noneMatch(effect -> effect instanceof Effect.Fired || effect instanceof Effect.DecisionOpened);
    }

    /** Clicks so far. */
    public long clicks() {
        return clicks;
    }

    /** The same by kind; kinds without clicks are left out. */
    public Map<ClickKind, Long> byKind() {
        return Map.copyOf(byKind);
    }

    private static ClickKind kindOf(Input input) {
        if (input instanceof Input.StartMission) {
            return ClickKind.START;
        }
        if (input instanceof Input.AbortMission || input instanceof Input.CompleteMission) {
            return ClickKind.ABORT;
        }
        return input instanceof Input.Interrupt ? ClickKind.PRESS : ClickKind.ANSWER;
    }

    private long clicksOf(Input input) {
        if (input instanceof Input.StartMission
                || input instanceof Input.AbortMission
                || input instanceof Input.CompleteMission) {
            return 1;
        }
        if (input instanceof Input.Interrupt interrupt) {
            return 1L + interrupt.proxies().size();
        }
        if (input instanceof Input.HoldDecision) {
            return 1;
        }
        if (input instanceof Input.AnswerDecision answered && answered.by() == Answerer.OPERATOR) {
            return ofAnswer(answered.answer(), Optional.ofNullable(open.get(answered.decision())));
        }
        return 0;
    }

    /** What an answer of the operator's to a question costs. */
    public static long ofAnswer(Answer answer, Question question) {
        return ofAnswer(answer, Optional.of(question));
    }

    /** Clicks for what is chosen or marked, and one to confirm; choosing an option or yes or no confirms itself. */
    private static long ofAnswer(Answer answer, Optional<Question> question) {
        if (answer instanceof Answer.Proxies chosen) {
            return chosen.proxies().size() + 1L;
        }
        if (answer instanceof Answer.Fields fields) {
            long marked = 0;
            for (Map.Entry<String, Value> field : fields.values().entrySet()) {
                boolean untouched = question.flatMap(asked -> defaultOf(asked, field.getKey()))
                        .filter(field.getValue()::equals)
                        .isPresent();
                marked += untouched ? 0 : marksIn(field.getValue());
            }
            return marked + 1;
        }
        return 1;
    }

    private static Optional<Value> defaultOf(Question question, String key) {
        if (!(question instanceof Question.FillIn fillIn)) {
            return Optional.empty();
        }
        return fillIn.items().stream()
                .filter(item -> item.key().equals(key))
                .flatMap(item -> item.defaultValue().stream())
                .findFirst();
    }

    /** Locations and boats in a value; what is typed in on the keyboard is no click. */
    private static long marksIn(Value value) {
        if (value instanceof GeoPoint || value instanceof ProxyValue) {
            return 1;
        }
        if (value instanceof GeoPath path) {
            return path.points().size();
        }
        if (value instanceof GeoArea area) {
            return area.outline().size()
                    + area.holes().stream().mapToLong(List::size).sum();
        }
        if (value instanceof ListValue list) {
            return list.items().stream().mapToLong(ClickCount::marksIn).sum();
        }
        if (value instanceof MapValue map) {
            return map.entries().values().stream()
                    .mapToLong(ClickCount::marksIn)
                    .sum();
        }
        if (value instanceof RecordValue fields) {
            return fields.fields().values().stream()
                    .mapToLong(ClickCount::marksIn)
                    .sum();
        }
        return 0;
    }
}

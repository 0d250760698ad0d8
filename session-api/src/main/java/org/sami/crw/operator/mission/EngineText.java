package org.sami.crw.operator.mission;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.crw.decision.ValueWords;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.protocol.TokenMove;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** What the engine did, in short words for reports and consoles. Nobody reads them back. */
public final class EngineText {
    private EngineText() {}

    /** The name of a transition, or its id where it has none. */
    public static String transition(Plan plan, String id) {
        return plan.transition(id)
                .map(Transition::name)
                .filter(name -> !name.isEmpty())
                .orElse(id);
    }

    /** Input events with whom they name. */
    public static String occurrences(List<Occurrence> used) {
        return used.stream().map(EngineText::occurrence).collect(Collectors.joining("; "));
    }

    private static String occurrence(Occurrence occurrence) {
        String tasks = occurrence.tasks().stream().map(TaskId::name).collect(Collectors.joining(" "));
        String proxies = String.join(" ", occurrence.proxies());
        String named = (proxies + " " + tasks).strip();
        return named.isEmpty() ? occurrence.type() : occurrence.type() + " (" + named + ")";
    }

    /** Tokens with the places that they left and entered. */
    public static String moves(Plan plan, List<TokenMove> moves) {
        return moves.stream().map(move -> move(plan, move)).collect(Collectors.joining("; "));
    }

    private static String move(Plan plan, TokenMove move) {
        return token(move.token()) + ": " + place(plan, move.from()) + " > " + place(plan, move.to());
    }

    private static String place(Plan plan, Optional<String> id) {
        return id.map(known -> plan.place(known)
                        .map(Place::name)
                        .filter(n -> !n.isEmpty())
                        .orElse(known))
                .orElse("-");
    }

    /** Whom a token stands for. */
    public static String token(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return proxy.proxy();
        }
        return token instanceof Token.Task task ? "task " + task.task().name() : "generic";
    }

    /** What was answered. */
    public static String answer(Answer answer) {
        if (answer instanceof Answer.YesNo yesNo) {
            return yesNo.yes() ? "yes" : "no";
        }
        if (answer instanceof Answer.Proxies chosen) {
            return String.join(" ", chosen.proxies());
        }
        if (answer instanceof Answer.Option option) {
            return "option " + (option.index() + 1);
        }
        if (answer instanceof Answer.Fields fields) {
            return fields.values().entrySet().stream()
                    .map(e -> e.getKey() + " = " + value(e.getValue()))
                    .collect(Collectors.joining("; "));
        }
        return "none of them";
    }

    /** A value; of a long one how much there is of it. */
    public static String value(Value value) {
        return ValueWords.of(value);
    }
}

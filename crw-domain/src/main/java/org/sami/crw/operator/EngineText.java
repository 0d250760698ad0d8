package org.sami.crw.operator;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.protocol.TokenMove;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;

/** What the engine did, in short words for reports and consoles. Nobody reads them back. */
public final class EngineText {
    private static final int ITEMS_SHOWN = 4;

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
        if (value instanceof ListValue list) {
            return items(list.items());
        }
        if (value instanceof GeoPath path) {
            return items(path.points());
        }
        if (value instanceof MapValue map) {
            return map.entries().entrySet().stream()
                    .limit(ITEMS_SHOWN)
                    .map(e -> value(e.getKey()) + ": " + value(e.getValue()))
                    .collect(Collectors.joining(", "));
        }
        if (value instanceof RecordValue record) {
            return record.type() + " " + record.fields().keySet();
        }
        return scalar(value);
    }

    private static String items(List<? extends Value> items) {
        if (items.size() > ITEMS_SHOWN) {
            return items.size() + " of " + items.get(0).getClass().getSimpleName();
        }
        return items.stream().map(EngineText::value).collect(Collectors.joining(", "));
    }

    private static String scalar(Value value) {
        if (value instanceof GeoPoint point) {
            return String.format(Locale.ROOT, "%.6f/%.6f", point.latDeg(), point.lonDeg());
        }
        if (value instanceof DurationValue duration) {
            return duration.millis() / 1000.0 + " s";
        }
        if (value instanceof TextValue text) {
            return text.value();
        }
        if (value instanceof RealValue real) {
            return String.valueOf(real.value());
        }
        if (value instanceof IntegerValue integer) {
            return String.valueOf(integer.value());
        }
        if (value instanceof BooleanValue truth) {
            return String.valueOf(truth.value());
        }
        return named(value);
    }

    private static String named(Value value) {
        if (value instanceof ProxyValue proxy) {
            return proxy.proxy();
        }
        if (value instanceof EnumValue constant) {
            return constant.constant();
        }
        if (value instanceof TaskId task) {
            return task.name();
        }
        if (value instanceof VariableReference variable) {
            return variable.variable();
        }
        return value instanceof PlanReference plan ? plan.plan() : value.toString();
    }
}

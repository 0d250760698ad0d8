package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledOutput;
import org.sami.spn.engine.net.OptionFilter;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;

/**
 * What an activation asks of the operator, and what autonomy would answer.
 *
 * <p>Implements R-DEC-4, R-DEC-10, R-DEC-11.
 */
final class Questions {
    private final RuleStep step;
    private final PendingOccurrences pendings;
    private final VariableScopes variables;

    Questions(RuleStep step, PendingOccurrences pendings, VariableScopes variables) {
        this.step = step;
        this.pendings = pendings;
        this.variables = variables;
    }

    String prompt(SentActivation sent) {
        Value question = sent.activation.values().get(Reserved.QUESTION);
        if (question instanceof TextValue text && !text.value().isBlank()) {
            return text.value();
        }
        String label = sent.output.type.map(EventType::label).orElse(sent.output.typeName);
        return label + " (" + sent.visit.place.place + ")";
    }

    Question of(SentActivation sent) {
        DecisionType type = sent.output.decision();
        return switch (type.form()) {
            case APPROVE -> new Question.Approve();
            case CHOOSE_PROXIES ->
                new Question.ChooseProxies(
                        kept(candidates(sent), type.min(), sent, (filter, robot) -> filter.keeps(robot, called(robot))),
                        type.min(),
                        type.max());
            case CHOOSE_OPTION -> new Question.ChooseOption(kept(options(sent), 1, sent, OptionFilter::keeps));
            case CHOOSE_VARIABLE ->
                new Question.ChooseOption(kept(variablesOfClass(sent), 1, sent, OptionFilter::keeps));
            case PROVIDE -> new Question.FillIn(fieldsOf(type.accepted()));
            case REDEFINE_VARIABLE -> new Question.FillIn(variables(sent, variable(sent)));
            case DEFINE_VARIABLES -> new Question.FillIn(variables(sent, listed(sent)));
        };
    }

    /** What the filters of the output event keep; all where that is less than must be chosen, as nobody could answer then. */
    private static <T> List<T> kept(
            List<T> offered, int least, SentActivation sent, BiPredicate<OptionFilter, T> keeps) {
        List<T> kept = offered;
        for (OptionFilter filter : sent.output.filters) {
            kept = kept.stream().filter(one -> keeps.test(filter, one)).toList();
        }
        return kept.size() < Math.max(1, least) ? offered : kept;
    }

    /** The other names of a robot that the session remembers. */
    private String called(String robot) {
        return step.state.memory.get(Reserved.DESCRIPTION_KEY + robot) instanceof TextValue text ? text.value() : "";
    }

    /** The robots that entered; where none did, those that stand in the place; else all known ones. */
    private List<String> candidates(SentActivation sent) {
        List<String> entered = sent.activation.proxies();
        if (!entered.isEmpty()) {
            return entered;
        }
        Set<String> standing = standing(sent);
        return standing.isEmpty() ? List.copyOf(step.state.proxies()) : List.copyOf(standing);
    }

    private static Set<String> standing(SentActivation sent) {
        Set<String> standing = new LinkedHashSet<>();
        PlaceState place = sent.visit.place;
        for (PlacedToken e = place.first(PlacedToken.PROXY); e != null; e = place.nextOfKind(e)) {
            standing.add(((Token.Proxy) e.token).proxy());
        }
        return standing;
    }

    /** Whether a choice offers those who stand in the place, as nobody entered it. */
    boolean offersStanding(SentActivation sent) {
        return sent.activation.proxies().isEmpty() && !standing(sent).isEmpty();
    }

    /** The robots that an open choice would offer now without its filters, among those for which it was asked. */
    List<String> all(OpenDecision open, Set<String> without) {
        SentActivation sent = open.sent;
        if (sent == null || open.purpose != OpenDecision.Purpose.ACTIVATION) {
            return List.of();
        }
        List<String> all = List.copyOf(step.state.proxies());
        if (!sent.activation.proxies().isEmpty()) {
            all = sent.activation.proxies().stream()
                    .filter(robot -> isIn(sent, new Token.Proxy(robot)))
                    .toList();
        } else if (open.subject.equals(OpenDecision.STANDING)) {
            all = List.copyOf(standing(sent));
        }
        return all.stream().filter(robot -> !without.contains(robot)).toList();
    }

    /** Whether a robot, or a task that it has, is still in the visit that asked. */
    private boolean isIn(SentActivation sent, Token robot) {
        for (Token token : pendings.tokensOf(robot, sent)) {
            if (sent.visit.has(token)) {
                return true;
            }
        }
        return false;
    }

    private List<Value> options(SentActivation sent) {
        String field = sent.output.decision().optionsField();
        Value options = sent.activation.values().get(field);
        if (options instanceof ListValue list) {
            return list.items();
        }
        return sent.output
                .type
                .flatMap(type -> type.field(field))
                .map(FieldType::type)
                .filter(ValueType.ListOf.class::isInstance)
                .map(list -> variables.valuesInScope(sent.mission(), ((ValueType.ListOf) list).element()))
                .orElse(List.of());
    }

    private List<Value> variablesOfClass(SentActivation sent) {
        Value named = sent.activation.values().get(Reserved.VARIABLE_CLASS);
        return Optional.ofNullable(named)
                .flatMap(value -> TypeNames.parse(CompiledInput.text(value)))
                .map(type -> variables.namesInScope(sent.mission(), type).stream()
                        .<Value>map(VariableReference::new)
                        .toList())
                .orElse(List.of());
    }

    private List<Question.Item> fieldsOf(String inputEvent) {
        List<Question.Item> items = new ArrayList<>();
        for (FieldType f : step.project()
                .vocabulary
                .event(inputEvent)
                .map(EventType::fields)
                .orElse(List.of())) {
            items.add(new Question.Item(f.name(), f.type(), f.unit(), f.defaultValue(), true, f.help()));
        }
        return items;
    }

    private static List<Value> variable(SentActivation sent) {
        Value named = sent.activation.values().get(Reserved.VARIABLE);
        return named == null ? List.of() : List.of(named);
    }

    private static List<Value> listed(SentActivation sent) {
        return sent.activation.values().get(Reserved.VARIABLES) instanceof ListValue list ? list.items() : List.of();
    }

    private List<Question.Item> variables(SentActivation sent, List<Value> named) {
        Set<String> names = new LinkedHashSet<>();
        named.forEach(
                value -> names.add(value instanceof VariableReference r ? r.variable() : CompiledInput.text(value)));
        names.remove("");
        return names.stream().map(name -> item(sent, name)).toList();
    }

    private Question.Item item(SentActivation sent, String name) {
        VariableSpec declared = variables.declaration(sent.mission(), name);
        Optional<Value> current = Optional.ofNullable(variables.read(sent.mission(), name));
        ValueType type = declared == null ? ValueType.Simple.ANY : declared.type();
        return new Question.Item(name, type, "", current, true, "New value of " + name);
    }

    /** What autonomy would answer to a question; empty where it has no sensible answer. */
    static Optional<Answer> automatic(CompiledOutput output, Question question) {
        return switch (output.decision().autonomy()) {
            case NONE -> Optional.empty();
            case YES -> question instanceof Question.Approve ? Optional.of(new Answer.YesNo(true)) : Optional.empty();
            case NO -> question instanceof Question.Approve ? Optional.of(new Answer.YesNo(false)) : Optional.empty();
            case ALL -> output.selectsNobody ? Optional.empty() : all(question);
            case FIRST ->
                question instanceof Question.ChooseOption o && !o.options().isEmpty()
                        ? Optional.of(new Answer.Option(0))
                        : Optional.empty();
            case DEFAULTS -> question instanceof Question.FillIn f ? defaults(f.items()) : Optional.empty();
        };
    }

    private static Optional<Answer> all(Question question) {
        if (question instanceof Question.ChooseProxies c
                && !c.proxies().isEmpty()
                && c.proxies().size() >= c.min()) {
            return Optional.of(new Answer.Proxies(
                    c.proxies().subList(0, Math.min(c.max(), c.proxies().size()))));
        }
        return Optional.empty();
    }

    /** The defaults of all items, empty where one has none. */
    static Optional<Answer> defaults(List<Question.Item> items) {
        Map<String, Value> values = new LinkedHashMap<>();
        for (Question.Item item : items) {
            if (item.defaultValue().isEmpty()) {
                return Optional.empty();
            }
            values.put(item.key(), item.defaultValue().get());
        }
        return Optional.of(new Answer.Fields(values));
    }
}

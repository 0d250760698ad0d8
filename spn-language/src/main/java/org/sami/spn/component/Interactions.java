package org.sami.spn.component;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Says which interaction an open decision is, or an event type whatever plan uses it. Yes or no and what is filled in is created, what is
 * offered is selected from, and the values of an event that asks nothing are selected, that is, shown (thesis 5.2.4).
 */
public final class Interactions {
    /** The name of the value where a question asks for one that has none. */
    public static final String ANSWER = "answer";

    private final Vocabulary vocabulary;

    public Interactions(Vocabulary vocabulary) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /** The interaction of an open decision; empty where it offers nothing and asks for nothing. */
    public Optional<Interaction> of(Decision decision) {
        List<MarkupOption> wanted = MarkupOption.of(decision.markups(), vocabulary);
        Question question = decision.question();
        if (question instanceof Question.Approve) {
            return Optional.of(approval(wanted));
        }
        if (question instanceof Question.ChooseProxies) {
            return Optional.of(selection(ValueType.Simple.PROXY, wanted));
        }
        if (question instanceof Question.FillIn fillIn) {
            Map<String, ValueType> values = new LinkedHashMap<>();
            fillIn.items().stream()
                    .filter(Question.Item::editable)
                    .forEach(item -> values.put(item.key(), item.type()));
            return creation(values, wanted);
        }
        return vocabulary
                .event(decision.type())
                .flatMap(this::optionType)
                .or(() -> Optional.of(ValueType.Simple.VARIABLE)) // all other choices are among variables
                .map(option -> selection(option, wanted));
    }

    /** The interaction of an event type; empty where only the plan defines its question, or it shows nothing. */
    public Optional<Interaction> of(EventType event, List<MarkupSpec> markups) {
        List<MarkupOption> wanted = MarkupOption.of(markups, vocabulary);
        if (event.decision().isEmpty()) {
            Map<String, ValueType> told = types(event.fields());
            return told.isEmpty() ? Optional.empty() : Optional.of(new Interaction(Purpose.SELECT, told, wanted));
        }
        DecisionType decision = event.decision().get();
        return switch (decision.form()) {
            case APPROVE -> Optional.of(approval(wanted));
            case CHOOSE_PROXIES -> Optional.of(selection(ValueType.Simple.PROXY, wanted));
            case CHOOSE_VARIABLE -> Optional.of(selection(ValueType.Simple.VARIABLE, wanted));
            case CHOOSE_OPTION -> optionType(event).map(option -> selection(option, wanted));
            case PROVIDE ->
                vocabulary.event(decision.accepted()).flatMap(given -> creation(types(given.fields()), wanted));
            case REDEFINE_VARIABLE, DEFINE_VARIABLES -> Optional.empty();
        };
    }

    private Optional<ValueType> optionType(EventType event) {
        return event.decision()
                .flatMap(decision -> event.field(decision.optionsField()))
                .map(FieldType::type)
                .filter(ValueType.ListOf.class::isInstance)
                .map(type -> ((ValueType.ListOf) type).element());
    }

    private static Map<String, ValueType> types(List<FieldType> fields) {
        Map<String, ValueType> types = new LinkedHashMap<>();
        fields.forEach(field -> types.put(field.name(), field.type()));
        return types;
    }

    private static Interaction approval(List<MarkupOption> wanted) {
        return new Interaction(Purpose.CREATE, Map.of(ANSWER, ValueType.Simple.BOOLEAN), wanted);
    }

    private static Interaction selection(ValueType option, List<MarkupOption> wanted) {
        return new Interaction(Purpose.SELECT, Map.of(ANSWER, new ValueType.ListOf(option)), wanted);
    }

    private static Optional<Interaction> creation(Map<String, ValueType> values, List<MarkupOption> wanted) {
        return values.isEmpty() ? Optional.empty() : Optional.of(new Interaction(Purpose.CREATE, values, wanted));
    }
}

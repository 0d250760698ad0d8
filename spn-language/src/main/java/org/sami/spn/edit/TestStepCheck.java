package org.sami.spn.edit;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.AnswerKeys;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TestStep;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/** Decides whether a step of a test case speaks of what is in its plan, with values of the right types. */
final class TestStepCheck {
    private final Plan plan;
    private final Vocabulary vocabulary;
    private final Map<String, OutputEventSpec> outputs = new LinkedHashMap<>();
    private final Map<String, ValueType> variables = new HashMap<>();

    TestStepCheck(Plan plan, List<VariableSpec> globals, Vocabulary vocabulary) {
        this.plan = plan;
        this.vocabulary = vocabulary;
        plan.places().forEach(p -> p.outputs().forEach(o -> outputs.put(o.id(), o)));
        globals.forEach(v -> variables.put(v.name(), v.type()));
        plan.variables().forEach(v -> variables.put(v.name(), v.type()));
    }

    /** Why a step means nothing, as the end of a sentence; empty where it means something. */
    Optional<String> problem(TestStep step) {
        if (step instanceof TestStep.ExpectTokens expect) {
            return plan.place(expect.place()).isPresent()
                    ? Optional.empty()
                    : Optional.of("there is no place " + expect.place());
        }
        if (step instanceof TestStep.Answer answer) {
            return answer(answer);
        }
        return step instanceof TestStep.Occur occur ? occur(occur) : Optional.empty();
    }

    private Optional<String> answer(TestStep.Answer answer) {
        if (!answer.event().isEmpty() && !outputs.containsKey(answer.event())) {
            return Optional.of("there is no output event " + answer.event());
        }
        return answer.reply() instanceof TestStep.Reply.Values given
                ? given.values().entrySet().stream()
                        .filter(e -> !isAsked(answer.event(), e.getKey(), e.getValue()))
                        .map(e -> "nothing is asked under the name " + e.getKey() + ", or something of another type")
                        .findFirst()
                : Optional.empty();
    }

    /** Whether a value answers what an output event asks, or with empty text the mission at its start. */
    boolean isAsked(String event, String key, Value value) {
        return AnswerKeys.type(vocabulary, outputs, variables, event, key)
                .filter(type -> TypeCheck.accepts(type, value, vocabulary.types()))
                .isPresent();
    }

    private Optional<String> occur(TestStep.Occur occur) {
        Optional<EventType> type = vocabulary.event(occur.type()).filter(t -> t.direction() == Direction.INPUT);
        if (type.isEmpty()) {
            return Optional.of("there is no input event " + occur.type());
        }
        if (!occur.answers().isEmpty() && !outputs.containsKey(occur.answers())) {
            return Optional.of("there is no output event " + occur.answers());
        }
        return occur.values().entrySet().stream()
                .filter(e -> !fits(type.get(), e.getKey(), e.getValue()))
                .map(e -> occur.type() + " has no field " + e.getKey() + " of that type")
                .findFirst();
    }

    private boolean fits(EventType type, String field, Value value) {
        return type.field(field)
                .map(FieldType::type)
                .filter(t -> TypeCheck.accepts(t, value, vocabulary.types()))
                .isPresent();
    }
}

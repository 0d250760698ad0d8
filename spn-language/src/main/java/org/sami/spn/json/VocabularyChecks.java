package org.sami.spn.json;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.AutonomyAnswer;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/** Checks what the events of a vocabulary say about each other. */
final class VocabularyChecks {
    private final Vocabulary vocabulary;
    private final Names events;
    private final Problems problems;

    /**
     * A check of one vocabulary.
     *
     * @param events the events' names with the places of their declarations
     */
    VocabularyChecks(Vocabulary vocabulary, Names events, Problems problems) {
        this.vocabulary = vocabulary;
        this.events = events;
        this.problems = problems;
    }

    void check() {
        vocabulary.events().values().forEach(event -> {
            if (event.direction() == Direction.INPUT) {
                checkInput(event);
            } else {
                event.answers().forEach(answer -> checkAnswer(event, answer));
                event.decision().ifPresent(decision -> checkDecision(event, decision));
            }
            if (event.direction() == Direction.OUTPUT && event.flags().contains(EventFlag.FAILURE)) {
                report(Codes.BAD_VALUE, event, "the flag failure is for input events");
            }
            RoleRules.check(event).ifPresent(message -> report(Codes.BAD_VALUE, event, message));
        });
    }

    private void checkInput(EventType event) {
        if (!event.answers().isEmpty() || event.decision().isPresent()) {
            report(Codes.ANSWERS, event, "an input event answers and has neither answers nor a decision of its own");
        }
    }

    private void checkAnswer(EventType event, String answer) {
        EventType found = vocabulary.events().get(answer);
        if (found == null || found.direction() != Direction.INPUT) {
            List<String> inputs = vocabulary.events().values().stream()
                    .filter(e -> e.direction() == Direction.INPUT)
                    .map(EventType::name)
                    .toList();
            report(
                    Codes.ANSWERS,
                    event,
                    "its answer " + answer + " is not an input event of this vocabulary"
                            + Suggestions.meant(inputs, answer));
        }
    }

    private void checkDecision(EventType event, DecisionType decision) {
        for (String answer : new String[] {decision.accepted(), decision.rejected()}) {
            if (!answer.isEmpty() && !event.answers().contains(answer)) {
                report(Codes.DECISION, event, "its decision answers " + answer + ", which is not among its answers");
            }
        }
        if (decision.form() == DecisionForm.CHOOSE_OPTION) {
            checkOptions(event, decision);
        } else if (decision.form() == DecisionForm.CHOOSE_VARIABLE) {
            checkAnswerFields(event, decision, ValueType.Simple.VARIABLE);
        } else if (!decision.optionsField().isEmpty()
                || !decision.answerFields().isEmpty()) {
            report(Codes.DECISION, event, "only a choice of options has optionsField and answerFields");
        }
        if (!fits(decision.autonomy(), decision.form())) {
            report(Codes.DECISION, event, "autonomy cannot answer that to such a question");
        }
        checkRejected(event, decision);
        checkFieldsOfVariables(event, decision.form());
    }

    private void checkRejected(EventType event, DecisionType decision) {
        boolean rejected = !decision.rejected().isEmpty();
        if (decision.form() == DecisionForm.APPROVE && !rejected) {
            report(Codes.DECISION, event, "its decision lacks \"rejected\"");
        } else if (rejected
                && decision.form() != DecisionForm.APPROVE
                && decision.form() != DecisionForm.CHOOSE_OPTION) {
            report(Codes.DECISION, event, "nothing can be rejected here");
        }
    }

    /** The fields that a decision on variables reads by fixed names. */
    private void checkFieldsOfVariables(EventType event, DecisionForm form) {
        switch (form) {
            case REDEFINE_VARIABLE -> expect(event, Reserved.VARIABLE, ValueType.Simple.VARIABLE);
            case DEFINE_VARIABLES -> expect(event, Reserved.VARIABLES, new ValueType.ListOf(ValueType.Simple.VARIABLE));
            case CHOOSE_VARIABLE -> expect(event, Reserved.VARIABLE_CLASS, ValueType.Simple.TEXT);
            default -> {}
        }
    }

    private void expect(EventType event, String field, ValueType type) {
        if (!event.field(field).map(FieldType::type).equals(Optional.of(type))) {
            report(
                    Codes.DECISION,
                    event,
                    "such a decision needs the field \"" + field + "\" of type " + TypeNames.of(type));
        }
    }

    private static boolean fits(AutonomyAnswer answer, DecisionForm form) {
        return switch (answer) {
            case NONE -> true;
            case YES, NO -> form == DecisionForm.APPROVE;
            case ALL -> form == DecisionForm.CHOOSE_PROXIES;
            case FIRST -> form == DecisionForm.CHOOSE_OPTION || form == DecisionForm.CHOOSE_VARIABLE;
            case DEFAULTS ->
                form == DecisionForm.PROVIDE
                        || form == DecisionForm.REDEFINE_VARIABLE
                        || form == DecisionForm.DEFINE_VARIABLES;
        };
    }

    private void checkOptions(EventType event, DecisionType decision) {
        Optional<ValueType> options = event.field(decision.optionsField()).map(FieldType::type);
        if (options.isEmpty() || !(options.get() instanceof ValueType.ListOf list)) {
            report(
                    Codes.DECISION,
                    event,
                    "its optionsField \"" + decision.optionsField() + "\" is no list of its fields");
            return;
        }
        checkAnswerFields(event, decision, list.element());
    }

    private void checkAnswerFields(EventType event, DecisionType decision, ValueType option) {
        EventType accepted = vocabulary.events().get(decision.accepted());
        if (accepted == null) {
            return;
        }
        for (Map.Entry<String, String> e : decision.answerFields().entrySet()) {
            Optional<ValueType> target = accepted.field(e.getKey()).map(FieldType::type);
            Optional<ValueType> source = part(option, e.getValue());
            if (target.isEmpty() || !target.equals(source)) {
                report(
                        Codes.DECISION,
                        event,
                        "\"" + e.getValue() + "\" of an option does not fit the field " + e.getKey() + " of "
                                + accepted.name());
            }
        }
    }

    private Optional<ValueType> part(ValueType option, String part) {
        if (part.equals(".")) {
            return Optional.of(option);
        }
        return option instanceof ValueType.Named named
                        && vocabulary.types().get(named.name()) instanceof NamedType.RecordType record
                ? Optional.ofNullable(record.fields().get(part))
                : Optional.empty();
    }

    private void report(String code, EventType event, String message) {
        problems.add(
                code,
                events.where(event.name()).orElse(""),
                "The event " + event.name() + ": " + message,
                event.name());
    }
}

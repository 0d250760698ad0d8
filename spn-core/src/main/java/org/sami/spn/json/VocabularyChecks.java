package org.sami.spn.json;

import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.AutonomyAnswer;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/** Checks what the events of a vocabulary say about each other. Its pointers name the event: {@code events#Name}. */
final class VocabularyChecks {
    private final Vocabulary vocabulary;
    private final Problems problems;

    VocabularyChecks(Vocabulary vocabulary, Problems problems) {
        this.vocabulary = vocabulary;
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
            report(Codes.ANSWERS, event, "its answer " + answer + " is not an input event of this vocabulary");
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
        } else if (!decision.optionsField().isEmpty()
                || !decision.answerFields().isEmpty()) {
            report(Codes.DECISION, event, "only choose-option has optionsField and answerFields");
        }
        if (!fits(decision.autonomy(), decision.form())) {
            report(Codes.DECISION, event, "autonomy cannot answer that to such a question");
        }
        boolean rejects = decision.form() == DecisionForm.APPROVE || decision.form() == DecisionForm.CHOOSE_OPTION;
        if (rejects == decision.rejected().isEmpty()) {
            report(Codes.DECISION, event, rejects ? "its decision lacks \"rejected\"" : "nothing can be rejected here");
        }
        if (decision.form() == DecisionForm.REDEFINE_VARIABLE
                && event.field(Reserved.VARIABLE).map(FieldType::type).orElse(ValueType.Simple.ANY)
                        != ValueType.Simple.VARIABLE) {
            report(Codes.DECISION, event, "a decision on a variable needs the field \"variable\" of type variable");
        }
    }

    private static boolean fits(AutonomyAnswer answer, DecisionForm form) {
        return switch (answer) {
            case NONE -> true;
            case YES, NO -> form == DecisionForm.APPROVE;
            case ALL -> form == DecisionForm.CHOOSE_PROXIES;
            case FIRST -> form == DecisionForm.CHOOSE_OPTION;
            case DEFAULTS -> form == DecisionForm.PROVIDE || form == DecisionForm.REDEFINE_VARIABLE;
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
        EventType accepted = vocabulary.events().get(decision.accepted());
        if (accepted == null) {
            return;
        }
        for (Map.Entry<String, String> e : decision.answerFields().entrySet()) {
            Optional<ValueType> target = accepted.field(e.getKey()).map(FieldType::type);
            Optional<ValueType> source = part(list.element(), e.getValue());
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
        problems.add(code, "events#" + event.name(), "The event " + event.name() + ": " + message, event.name());
    }
}

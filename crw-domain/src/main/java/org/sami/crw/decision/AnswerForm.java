package org.sami.crw.decision;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.json.Reading;
import org.sami.spn.json.ValueJson;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/** Whether an answer in a file has the form that its decision asks for, as far as the vocabulary tells. */
final class AnswerForm {
    static final String SILENT = "silent";
    static final String YES = "yes";
    static final String BOATS = "boats";
    static final String OPTION = "option";
    static final String REJECT = "reject";
    static final String VALUES = "values";
    static final String VALUE = "value";

    private static final List<String> APPROVAL = List.of(YES, SILENT);
    private static final List<String> CHOICE = List.of(BOATS, SILENT);

    private AnswerForm() {}

    /** Checks an answer to an output event's decision. */
    static void check(
            JsonNode answer, String pointer, DecisionType decision, Vocabulary vocabulary, List<Finding> findings) {
        Optional<String> member = check(answer, pointer, membersFor(decision), findings);
        if (decision.form() == DecisionForm.PROVIDE && member.equals(Optional.of(VALUES))) {
            checkFields(answer.get(VALUES), pointer + "/" + VALUES, decision.accepted(), vocabulary, findings);
        }
    }

    /** Checks an answer to a question that no event asks and that is answered by yes or no. */
    static void checkYesNo(JsonNode answer, String pointer, List<Finding> findings) {
        check(answer, pointer, APPROVAL, findings);
    }

    /** Checks an answer to the question whom an interrupt is for. */
    static void checkInterrupt(JsonNode answer, String pointer, List<Finding> findings) {
        check(answer, pointer, CHOICE, findings);
    }

    /** The one member that the answer has; empty where it is another than allowed. */
    private static Optional<String> check(
            JsonNode answer, String pointer, List<String> allowed, List<Finding> findings) {
        Optional<String> member = only(answer, pointer, allowed, findings);
        member.ifPresent(name -> checkMember(answer.get(name), pointer + "/" + name, name, findings));
        return member;
    }

    /** Checks an answer to what is asked at the start. */
    static void checkStart(JsonNode answer, String pointer, List<Finding> findings) {
        only(answer, pointer, List.of(VALUE), findings);
    }

    private static List<String> membersFor(DecisionType decision) {
        return switch (decision.form()) {
            case APPROVE -> APPROVAL;
            case CHOOSE_PROXIES -> CHOICE;
            case CHOOSE_OPTION, CHOOSE_VARIABLE ->
                decision.rejected().isEmpty() ? List.of(OPTION, SILENT) : List.of(OPTION, REJECT, SILENT);
            case PROVIDE, REDEFINE_VARIABLE, DEFINE_VARIABLES -> List.of(VALUES, SILENT);
        };
    }

    private static Optional<String> only(
            JsonNode answer, String pointer, List<String> allowed, List<Finding> findings) {
        List<String> names = new ArrayList<>();
        answer.fieldNames().forEachRemaining(names::add);
        if (names.size() != 1 || !allowed.contains(names.get(0))) {
            findings.add(
                    Finding.error("E-DECISION", pointer, "The answer has one member of " + allowed + ", not " + names));
            return Optional.empty();
        }
        return Optional.of(names.get(0));
    }

    private static void checkMember(JsonNode value, String pointer, String member, List<Finding> findings) {
        String wanted = switch (member) {
            case SILENT, REJECT -> value.isBoolean() && value.booleanValue() ? "" : "true";
            case YES -> value.isBoolean() ? "" : "true or false";
            case OPTION -> isCount(value) ? "" : "an option's number, from 0";
            case BOATS -> isBoats(value) ? "" : "a list of boats, a number of boats or \"all\"";
            default -> value.isObject() ? "" : "an object with a value per field";
        };
        if (!wanted.isEmpty()) {
            String message = "\"" + member + "\" is " + wanted + ", not " + shown(value);
            findings.add(Finding.error("E-BAD-VALUE", pointer, message));
        }
    }

    private static boolean isCount(JsonNode value) {
        return value.isInt() && value.intValue() >= 0;
    }

    private static boolean isBoats(JsonNode value) {
        if (value.isArray()) {
            for (JsonNode boat : value) {
                if (!boat.isTextual()) {
                    return false;
                }
            }
            return true;
        }
        return isCount(value) || value.asText().equals("all");
    }

    private static void checkFields(
            JsonNode values, String pointer, String event, Vocabulary vocabulary, List<Finding> findings) {
        EventType type = vocabulary.event(event).orElseThrow();
        for (Map.Entry<String, JsonNode> given : values.properties()) {
            String at = pointer + "/" + given.getKey();
            Optional<FieldType> field = type.field(given.getKey());
            if (field.isEmpty()) {
                String meant = Suggestions.meant(
                        type.fields().stream().map(FieldType::name).toList(), given.getKey());
                findings.add(Finding.error(
                        "E-UNKNOWN-FIELD", at, type.name() + " has no field \"" + given.getKey() + "\"" + meant));
                continue;
            }
            Reading<Value> reading =
                    ValueJson.read(given.getValue(), field.get().type(), vocabulary.types());
            for (Finding f : reading.findings()) {
                findings.add(f.within(at));
            }
        }
    }

    /** What stands there, as messages say it. */
    static String shown(JsonNode node) {
        return node.isMissingNode() ? "missing" : Objects.toString(node);
    }
}

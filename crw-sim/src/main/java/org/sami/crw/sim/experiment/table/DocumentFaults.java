package org.sami.crw.sim.experiment.table;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.value.TextNumbers;

/** Reads values of a document and collects what is wrong with it. A place is a JSON pointer. */
final class DocumentFaults {
    private final Set<Finding> findings = new LinkedHashSet<>();

    void add(String code, String pointer, String message) {
        findings.add(Finding.error(code, pointer, message));
    }

    void addAll(List<Finding> more) {
        findings.addAll(more);
    }

    List<Finding> findings() {
        return List.copyOf(findings);
    }

    boolean areNone() {
        return findings.isEmpty();
    }

    /** Whether it is an object, all of whose members are known. */
    boolean isObject(JsonNode node, String pointer, List<String> known) {
        if (!node.isObject()) {
            add("E-WRONG-TYPE", pointer, "An object stands here, not " + shown(node));
            return false;
        }
        node.fieldNames().forEachRemaining(member -> {
            if (!known.contains(member)) {
                add(
                        "E-UNKNOWN-MEMBER",
                        pointer + "/" + escaped(member),
                        "\"" + member + "\" is not known here; known are " + String.join(", ", known)
                                + Suggestions.meant(known, member));
            }
        });
        return true;
    }

    /** A text; numbers are texts too. */
    Optional<String> text(JsonNode node, String pointer) {
        if (node.isTextual() || node.isNumber()) {
            return Optional.of(node.asText());
        }
        add("E-WRONG-TYPE", pointer, "A text or a number stands here, not " + shown(node));
        return Optional.empty();
    }

    /** A text that may be left out. */
    String text(JsonNode object, String member, String pointer, String otherwise) {
        return object.has(member)
                ? text(object.get(member), pointer + "/" + escaped(member)).orElse(otherwise)
                : otherwise;
    }

    /** A number in a range. */
    double number(JsonNode node, String pointer, double least, double most) {
        OptionalDouble number = node.isNumber() || node.isTextual()
                ? TextNumbers.real(node.asText(), least, most)
                : OptionalDouble.empty();
        if (number.isEmpty()) {
            add("E-BAD-VALUE", pointer, "A number from " + least + " to " + most + " stands here, not " + shown(node));
        }
        return number.orElse(least);
    }

    /** Whether it is a list. */
    boolean isList(JsonNode node, String pointer) {
        if (!node.isArray()) {
            add("E-WRONG-TYPE", pointer, "A list stands here, not " + shown(node));
        }
        return node.isArray();
    }

    static String shown(JsonNode node) {
        return node.isMissingNode() ? "nothing" : node.toString();
    }

    static String escaped(String member) {
        return member.replace("~", "~0").replace("/", "~1");
    }
}

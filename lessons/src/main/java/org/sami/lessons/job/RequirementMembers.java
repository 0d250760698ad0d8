package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;

/** Requirements by their members in a plan file, so that some of them can be asked for. */
final class RequirementMembers {
    /** All members there are. */
    static final Set<String> NAMES = Set.of("kind", "match", "n", "task", "action");

    private RequirementMembers() {}

    /** Whether a requirement has these members, whatever else it has. */
    static boolean fit(InRequirement requirement, Map<String, JsonNode> wanted) {
        Map<String, String> members = new LinkedHashMap<>();
        members.put("kind", word(requirement.kind()));
        members.put("task", requirement.task());
        if (requirement.kind() != TokenKind.UNCONDITIONAL) {
            members.put("match", word(requirement.match()));
            members.put("n", String.valueOf(requirement.n()));
        }
        return fit(members, wanted);
    }

    /** Whether a requirement has these members, whatever else it has. */
    static boolean fit(OutRequirement requirement, Map<String, JsonNode> wanted) {
        Map<String, String> members = new LinkedHashMap<>();
        members.put("kind", word(requirement.kind()));
        members.put("task", requirement.task());
        if (requirement.kind() != TokenKind.UNCONDITIONAL) {
            members.put("action", word(requirement.action()));
            members.put("n", requirement.takesAll() ? "all" : String.valueOf(requirement.n()));
        }
        return fit(members, wanted);
    }

    private static boolean fit(Map<String, String> members, Map<String, JsonNode> wanted) {
        return wanted.entrySet().stream()
                .allMatch(member -> member.getValue().asText().equals(members.get(member.getKey())));
    }

    private static String word(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}

package org.sami.spn.drawing;

import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;

/** Requirements in the words of the thesis (4.1.3, 4.1.4; 5.3): "≥ 1 Generic", "Take All Relevant". */
public final class RequirementWords {
    private RequirementWords() {}

    /** Of an in edge. */
    public static String of(InRequirement requirement) {
        if (requirement.kind() == TokenKind.UNCONDITIONAL) {
            return "No Condition";
        }
        String kind = kind(requirement.kind(), requirement.task());
        return switch (requirement.match()) {
            case ZERO -> "No " + kind;
            case LESS_THAN -> "< " + requirement.n() + " " + kind;
            case AT_LEAST -> "≥ " + requirement.n() + " " + kind;
            case EXACTLY -> "= " + requirement.n() + " " + kind;
            case ALL -> "All " + kind;
        };
    }

    /** Of an out edge. */
    public static String of(OutRequirement requirement) {
        if (requirement.kind() == TokenKind.UNCONDITIONAL) {
            return "Enter With Nobody";
        }
        String action = switch (requirement.action()) {
            case TAKE -> "Take ";
            case CONSUME -> "Consume ";
            case ADD -> "Add ";
        };
        return action + (requirement.takesAll() ? "All" : requirement.n()) + " "
                + kind(requirement.kind(), requirement.task());
    }

    private static String kind(TokenKind kind, String task) {
        return switch (kind) {
            case GENERIC -> "Generic";
            case ANY_PROXY -> "Proxy";
            case ANY_TASK -> "Task";
            case ANY_TOKEN -> "Token";
            case TASK -> "Task " + task;
            case RELEVANT -> "Relevant";
            case SUB_MISSION_TOKENS -> "Sub-mission";
            case UNCONDITIONAL -> "";
        };
    }
}

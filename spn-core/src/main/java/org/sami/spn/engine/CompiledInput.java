package org.sami.spn.engine;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Reserved;

/** One input event of a transition. */
final class CompiledInput {
    final int index;
    final int typeId;
    final InputEventSpec spec;
    final EventRole role;
    final List<Map.Entry<String, String>> writes;
    /** The interrupt's name or the compared return value; null where the specification gives none. */
    final String selector;

    CompiledInput(CompiledProject project, int index, InputEventSpec spec) {
        this.index = index;
        this.spec = spec;
        this.typeId = project.typeId(spec.type());
        this.role = project.vocabulary.event(spec.type()).map(EventType::role).orElse(EventRole.NONE);
        this.writes = List.copyOf(spec.writes().entrySet());
        String field = role == EventRole.CHECK_RETURN ? Reserved.VALUE : Reserved.INTERRUPT_NAME;
        this.selector = Optional.ofNullable(spec.fields().get(field))
                .map(CompiledInput::text)
                .orElse(null);
    }

    static String text(Value value) {
        return value instanceof TextValue text ? text.value() : String.valueOf(value);
    }

    /** Occurrences that are never kept: the transition fires now or refuses them. */
    boolean isPress() {
        return isPress(role);
    }

    /** Whether it waits for a return of that value. */
    boolean checks(String returnValue) {
        return role == EventRole.CHECK_RETURN && returnValue.equals(selector);
    }

    static boolean isPress(EventRole role) {
        return switch (role) {
            case ABORT_RECEIVED, COMPLETE_RECEIVED -> true;
            default -> isInterrupt(role);
        };
    }

    /** Whether it is the press of a button. */
    static boolean isInterrupt(EventRole role) {
        return switch (role) {
            case INTERRUPT, GENERAL_INTERRUPT_RECEIVED, PROXY_INTERRUPT_RECEIVED -> true;
            default -> false;
        };
    }
}

package org.sami.spn.engine.net;

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
public final class CompiledInput {
    public final int index;
    public final int typeId;
    public final InputEventSpec spec;
    public final EventRole role;
    public final List<Map.Entry<String, String>> writes;
    /** The interrupt's name or the compared return value; null where the specification gives none. */
    public final String selector;

    public CompiledInput(CompiledProject project, int index, InputEventSpec spec) {
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

    public static String text(Value value) {
        return value instanceof TextValue text ? text.value() : String.valueOf(value);
    }

    /** Occurrences that are never kept: the transition fires now or refuses them. */
    public boolean isPress() {
        return isPress(role);
    }

    /** Whether it waits for a return of that value. */
    public boolean checks(String returnValue) {
        return role == EventRole.CHECK_RETURN && returnValue.equals(selector);
    }

    public static boolean isPress(EventRole role) {
        return switch (role) {
            case ABORT_RECEIVED, COMPLETE_RECEIVED -> true;
            default -> isInterrupt(role);
        };
    }

    /** Whether it is the press of a button. */
    public static boolean isInterrupt(EventRole role) {
        return switch (role) {
            case INTERRUPT, GENERAL_INTERRUPT_RECEIVED, PROXY_INTERRUPT_RECEIVED -> true;
            default -> false;
        };
    }
}

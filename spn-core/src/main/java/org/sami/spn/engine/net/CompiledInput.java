package org.sami.spn.engine.net;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/** One input event of a transition. */
public final class CompiledInput {
    public final int index;
    public final int typeId;
    public final InputEventSpec spec;
    public final EventRole role;
    public final List<Map.Entry<String, String>> writes;
    /** The interrupt's name or the compared return value; null where the specification gives none. */
    public final @Nullable String selector;
    /** The plan whose sub-missions' returns are checked; null where those of any are. */
    private final @Nullable String checkedPlan;

    CompiledInput(int index, InputEventSpec spec, int typeId, EventRole role) {
        this.index = index;
        this.spec = spec;
        this.typeId = typeId;
        this.role = role;
        this.writes = List.copyOf(spec.writes().entrySet());
        String field = role == EventRole.CHECK_RETURN ? Reserved.VALUE : Reserved.INTERRUPT_NAME;
        this.selector = Optional.ofNullable(spec.fields().get(field))
                .map(CompiledInput::text)
                .orElse(null);
        this.checkedPlan =
                role == EventRole.CHECK_RETURN && spec.fields().get(Reserved.SUB_MISSION) instanceof PlanReference named
                        ? named.plan()
                        : null;
    }

    public static String text(Value value) {
        return value instanceof TextValue text ? text.value() : String.valueOf(value);
    }

    /** Occurrences that are never kept: the transition fires now or refuses them. */
    public boolean isPress() {
        return role.isPress();
    }

    /** Whether it waits for a return of that value from a sub-mission of that plan. */
    public boolean checks(String returnValue, String plan) {
        return role == EventRole.CHECK_RETURN
                && returnValue.equals(selector)
                && (checkedPlan == null || checkedPlan.equals(plan));
    }
}

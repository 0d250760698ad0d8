package org.sami.spn.engine.rule;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/**
 * Reads and writes variables in their scopes (thesis 3.1, Variables).
 *
 * <p>Implements R-VAR-1, R-VAR-2, R-VAR-3.
 */
public final class VariableScopes {
    /** Where a name leads: a mission, or the globals where it is null, and the name there. */
    private record Place(
            @Nullable MissionState owner,
            String name,
            @Nullable VariableSpec declaration) {}

    private final RuleStep step;

    VariableScopes(RuleStep step) {
        this.step = step;
    }

    /** A variable as a mission reads it, null mission = globals; null where it has no value. */
    @Nullable
    Value read(@Nullable MissionState mission, String variable) {
        return read(step.state, mission, variable);
    }

    /** The same in any state, between two steps too. */
    public static @Nullable Value read(NetState state, @Nullable MissionState mission, String variable) {
        String name = variable;
        for (MissionState m = mission; m != null; m = m.parent) {
            String mapped = mapping(m).get(name);
            if (mapped != null) {
                name = mapped;
                continue;
            }
            Value value = m.variables.get(name);
            if (value != null || m.plan.variables.containsKey(name)) {
                return value;
            }
        }
        return projectOf(state, mission).globals.containsKey(name) ? state.globals.get(name) : null;
    }

    /** The declaration that a write of a mission would meet, or null. */
    public @Nullable VariableSpec declaration(@Nullable MissionState mission, String variable) {
        return place(mission, variable).declaration;
    }

    /** Writes a variable where the nearest enclosing plan declares it, else in the own plan; says whether it fits. */
    public boolean write(@Nullable MissionState mission, String variable, Value value) {
        Place place = place(mission, variable);
        if (!fits(place.declaration, value)) {
            step.note(
                    NoteKind.REJECTED_INPUT,
                    mission == null ? Ids.NONE : mission.id,
                    "The variable " + variable + " keeps its value: " + value + " is not of its type");
            return false;
        }
        if (place.owner == null) {
            step.state.globals.put(place.name, value);
        } else {
            place.owner.setVariable(place.name, value);
        }
        step.emit(new Effect.VariableWritten(place.owner == null ? Ids.NONE : place.owner.id, place.name, value));
        return true;
    }

    /** The declared variables of a type that a mission can read, its own first, the globals last. */
    public List<String> namesInScope(@Nullable MissionState mission, ValueType type) {
        return declaredInScope(mission).entrySet().stream()
                .filter(e -> e.getValue().type().equals(type))
                .map(Map.Entry::getKey)
                .toList();
    }

    /** The values of a type that variables hold which a mission can read, its own first, the globals last. */
    public List<Value> valuesInScope(@Nullable MissionState mission, ValueType type) {
        return declaredInScope(mission).keySet().stream()
                .map(name -> read(mission, name))
                .filter(value -> value != null
                        && TypeCheck.accepts(
                                type, value, step.project().vocabulary.types()))
                .distinct()
                .toList();
    }

    private Map<String, VariableSpec> declaredInScope(@Nullable MissionState mission) {
        Map<String, VariableSpec> declared = new LinkedHashMap<>();
        for (MissionState m = mission; m != null; m = m.parent) {
            m.plan.variables.forEach(declared::putIfAbsent);
        }
        projectOf(step.state, mission).globals.forEach(declared::putIfAbsent);
        return declared;
    }

    public boolean fits(@Nullable VariableSpec declaration, Value value) {
        return declaration == null
                || TypeCheck.accepts(
                        declaration.type(), value, step.project().vocabulary.types());
    }

    private Place place(@Nullable MissionState mission, String variable) {
        String name = variable;
        MissionState own = mission;
        String ownName = variable;
        for (MissionState m = mission; m != null; m = m.parent) {
            String mapped = mapping(m).get(name);
            if (mapped != null) {
                name = mapped;
                own = m.parent;
                ownName = mapped;
                continue;
            }
            VariableSpec declaration = m.plan.variables.get(name);
            if (declaration != null) {
                return new Place(m, name, declaration);
            }
        }
        VariableSpec global = projectOf(step.state, mission).globals.get(name);
        return global != null || mission == null ? new Place(null, name, global) : new Place(own, ownName, null);
    }

    /** Whose globals a mission reads and writes: those of the project that it started with; with no mission, of the newest. */
    private static CompiledProject projectOf(NetState state, @Nullable MissionState mission) {
        return mission == null ? state.newest() : mission.plan.project;
    }

    private static Map<String, String> mapping(MissionState m) {
        SubMissionSpec spec = m.subMission();
        return spec == null ? Map.of() : spec.variables();
    }
}

package org.sami.crw.gui.mission;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.Value;

/**
 * The global variables of the newest project at a moment, as the engine has them. Immutable.
 *
 * @param values those that have one now, by name
 * @param readers titles of running missions that read them, by name
 * @param saved the values that the project's file has, by name
 */
record GlobalsState(
        Project project, Map<String, Value> values, Map<String, List<String>> readers, Map<String, Value> saved) {
    GlobalsState {
        values = Map.copyOf(values);
        readers = Map.copyOf(readers);
        saved = Collections.unmodifiableMap(new LinkedHashMap<>(saved));
    }

    /** As an engine has them. */
    static GlobalsState of(EngineView view) {
        Map<String, List<String>> readers = new HashMap<>();
        view.missions().forEach(mission -> {
            Optional<Plan> plan = view.planOf(mission.id());
            plan.ifPresent(one -> one.reads()
                    .forEach(name -> readers.computeIfAbsent(name, key -> new ArrayList<>())
                            .add(one.title() + " (" + mission.id() + ")")));
        });
        Map<String, Value> initial = new HashMap<>();
        view.project()
                .globals()
                .forEach(global -> global.initial().ifPresent(value -> initial.put(global.name(), value)));
        return new GlobalsState(view.project(), view.globals(), readers, initial);
    }

    /** The same after these values were saved. */
    GlobalsState withSaved(Map<String, Value> now) {
        Map<String, Value> all = new HashMap<>(saved);
        all.putAll(now);
        return new GlobalsState(project, values, readers, all);
    }

    /** The value that a global has now. */
    Optional<Value> value(VariableSpec global) {
        return Optional.ofNullable(values.get(global.name()));
    }

    /** Whether it has another value than the project says. */
    boolean differs(VariableSpec global) {
        return value(global).isPresent() && !value(global).get().equals(saved.get(global.name()));
    }

    /** How many have another value than the project says. */
    long differing() {
        return project.globals().stream().filter(this::differs).count();
    }

    /** The running missions that read it and see a new value at once, in words. */
    String readBy(VariableSpec global) {
        List<String> titles = readers.getOrDefault(global.name(), List.of());
        return titles.isEmpty()
                ? "No running mission reads it; missions that start from now on have the new value."
                : "A new value counts at once for " + String.join(", ", titles) + ".";
    }
}

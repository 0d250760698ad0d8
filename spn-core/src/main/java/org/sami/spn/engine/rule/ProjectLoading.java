package org.sami.spn.engine.rule;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/**
 * Loads a project while missions run (decision 0176, docs/session.md). Those keep their plans; a global keeps its value
 * where its name and type stay.
 *
 * <p>Implements R-LOAD-1, R-LOAD-2 and R-LOAD-3.
 */
public final class ProjectLoading {
    private final RuleStep step;

    ProjectLoading(RuleStep step) {
        this.step = step;
    }

    /** Loads a project; a reason where it cannot, and then nothing has changed. */
    public Optional<String> load(Input.LoadProject input) {
        CompiledProject before = step.state.newest();
        Reading<Project> reading = new ProjectReader(before.vocabulary).read(input.document());
        if (reading.result().isEmpty()) {
            return Optional.of("The project cannot be loaded: "
                    + reading.findings().stream().map(Finding::message).collect(Collectors.joining("; ")));
        }
        Project project = reading.result().get();
        if (project.equals(before.project)) {
            step.emit(new Effect.ProjectLoaded(before.version, before.project));
            return Optional.empty();
        }
        Optional<String> conflict = project.globals().stream()
                .flatMap(declared -> conflict(declared).stream())
                .findFirst();
        if (conflict.isPresent()) {
            return conflict;
        }
        load(before, new CompiledProject(before, before.version + 1, project, input.sha256()));
        return Optional.empty();
    }

    /** Running missions go on reading and writing their globals: none may become of another type under them. */
    private Optional<String> conflict(VariableSpec declared) {
        for (MissionState m : step.state.missions.values()) {
            VariableSpec running = m.plan.project.globals.get(declared.name());
            if (running != null && !running.type().equals(declared.type())) {
                return Optional.of("The project cannot be loaded while mission " + m.root.id + " ("
                        + m.root.plan.plan.title()
                        + ") runs: its global " + declared.name() + " is of type " + TypeNames.of(running.type())
                        + ", in the project to load of type " + TypeNames.of(declared.type())
                        + "; end the mission, or give the global another name");
            }
        }
        return Optional.empty();
    }

    private void load(CompiledProject before, CompiledProject loaded) {
        Set<CompiledProject> earlier = new LinkedHashSet<>(step.state.running());
        earlier.add(before);
        for (VariableSpec declared : loaded.project.globals()) {
            if (!hasType(earlier, declared.name(), declared.type())) {
                step.state.globals.removeIf(declared.name()::equals);
            }
        }
        step.state.load(loaded);
        step.emit(new Effect.ProjectLoaded(loaded.version, loaded.project));
        loaded.project.globals().forEach(declared -> begin(declared, before.globals.get(declared.name())));
    }

    private static boolean hasType(Set<CompiledProject> projects, String global, ValueType type) {
        return projects.stream()
                .map(project -> project.globals.get(global))
                .anyMatch(spec -> spec != null && spec.type().equals(type));
    }

    /** Gives a global that has no value its initial one; reports another initial value that does not count. */
    private void begin(VariableSpec declared, @Nullable VariableSpec before) {
        if (declared.initial().isEmpty()) {
            return;
        }
        Value initial = declared.initial().get();
        Value value = step.state.globals.get(declared.name());
        if (value == null) {
            step.state.globals.put(declared.name(), initial);
            step.emit(new Effect.VariableWritten(Ids.NONE, declared.name(), initial));
        } else if (!value.equals(initial)
                && (before == null || !before.initial().equals(declared.initial()))) {
            step.note(
                    NoteKind.GLOBAL_KEPT,
                    Ids.NONE,
                    "The global " + declared.name() + " keeps its value " + value
                            + "; in the loaded project it begins with " + initial);
        }
    }
}

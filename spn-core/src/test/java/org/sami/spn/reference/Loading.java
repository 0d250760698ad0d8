package org.sami.spn.reference;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.value.Value;

/** Loading a project while missions run, as decision 0176 and docs/session.md state it. */
final class Loading {
    static final String REFUSED = "The project cannot be loaded";

    private final World world;

    Loading(World world) {
        this.world = world;
    }

    void load(Input.LoadProject input) {
        Project before = world.project;
        Optional<Project> read =
                new ProjectReader(world.vocabulary).read(input.document()).result();
        List<Project> running = running();
        // "refused where a global of a running mission would change its type", and where it cannot be read
        if (read.isEmpty() || read.get().globals().stream().anyMatch(g -> isOfAnotherType(running, g))) {
            world.note(NoteKind.REJECTED_INPUT, Ids.NONE, REFUSED);
            return;
        }
        Project project = read.get();
        if (!project.equals(before)) { // "a project equal to the newest is no new version"
            world.project = project;
            world.projectVersion++;
        }
        world.effects.add(new Effect.ProjectLoaded(world.projectVersion, world.project));
        if (!project.equals(before)) {
            List<Project> earlier =
                    Stream.concat(running.stream(), Stream.of(before)).toList();
            project.globals().forEach(global -> carryOver(global, earlier, Variables.global(before, global.name())));
            forget();
        }
    }

    /** "A global lives as long as the newest project or that of a running mission declares it". */
    void forget() {
        List<Project> running = running();
        world.globals
                .keySet()
                .removeIf(name -> Stream.concat(running.stream(), Stream.of(world.project))
                        .noneMatch(p -> Variables.global(p, name).isPresent()));
    }

    /** "It keeps its value where name and type stay, else it begins with its initial value". */
    private void carryOver(VariableSpec global, List<Project> earlier, Optional<VariableSpec> before) {
        String name = global.name();
        boolean typeStays = earlier.stream()
                .flatMap(p -> Variables.global(p, name).stream())
                .anyMatch(g -> g.type().equals(global.type()));
        Value value = typeStays ? world.globals.get(name) : null;
        if (value == null) {
            world.globals.remove(name);
            global.initial().ifPresent(initial -> {
                world.globals.put(name, initial);
                world.effects.add(new Effect.VariableWritten(Ids.NONE, name, initial));
            });
        } else if (global.initial().isPresent()
                && !global.initial().get().equals(value)
                && !before.map(VariableSpec::initial).equals(Optional.of(global.initial()))) {
            world.note(NoteKind.GLOBAL_KEPT, Ids.NONE, name);
        }
    }

    private static boolean isOfAnotherType(List<Project> running, VariableSpec global) {
        return running.stream()
                .flatMap(p -> Variables.global(p, global.name()).stream())
                .anyMatch(g -> !g.type().equals(global.type()));
    }

    private List<Project> running() {
        return world.missions.stream()
                .filter(m -> m.status != Mission.Status.ENDED)
                .map(m -> m.project)
                .toList();
    }
}

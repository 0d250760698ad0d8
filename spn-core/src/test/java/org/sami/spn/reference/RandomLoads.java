package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.ValueType;

/** Projects to be loaded during a random session: other random plans, with other globals. */
final class RandomLoads {
    private static final List<List<VariableSpec>> GLOBALS = List.of(
            List.of(),
            List.of(integer("@global", 100)),
            List.of(integer("@global", 200)),
            List.of(integer("@more", 5), integer("@global", 100)),
            List.of(new VariableSpec("@global", ValueType.Simple.INTEGER, Optional.empty())),
            List.of(new VariableSpec("@global", ValueType.Simple.TEXT, Optional.of(new TextValue("words")))));

    private RandomLoads() {}

    /** Those of a session: the one with which it began, three others, and what is no project. */
    static List<Input> of(Project began, long seed) {
        List<Input> loads = new ArrayList<>();
        loads.add(load(began));
        for (int i = 1; loads.size() < 4; i++) {
            Project other = RandomPlans.project(seed * 31 + i);
            List<VariableSpec> globals = GLOBALS.get((int) ((seed + i) % GLOBALS.size()));
            readable(new Project(other.id(), other.name(), other.domain(), globals, other.missionTree(), other.plans()))
                    .ifPresent(project -> loads.add(load(project)));
        }
        loads.add(new Input.LoadProject("no project"));
        return loads;
    }

    /** A random project as a file can hold it; empty where it makes too little sense for one. */
    static Optional<Project> readable(Project random) {
        try {
            return new ProjectReader(TestVocabulary.TEST).read(text(random)).result();
        } catch (IllegalArgumentException noFileHoldsIt) {
            return Optional.empty();
        }
    }

    static Input load(Project project) {
        return new Input.LoadProject(text(project));
    }

    private static String text(Project project) {
        return new ProjectWriter(TestVocabulary.TEST).text(project);
    }

    private static VariableSpec integer(String name, long initial) {
        return new VariableSpec(name, ValueType.Simple.INTEGER, Optional.of(new IntegerValue(initial)));
    }
}

package org.sami.spn.geotext;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;

/** Adds global variables to a project. */
public final class ProjectVariables {
    private ProjectVariables() {}

    /** Names of those that the project has already. */
    public static List<String> collisions(Project project, List<VariableSpec> added) {
        List<String> here = project.globals().stream().map(VariableSpec::name).toList();
        return added.stream().map(VariableSpec::name).filter(here::contains).toList();
    }

    /** The project with the variables: those of the same name replaced where they stand, new ones at the end. */
    public static Project with(Project project, List<VariableSpec> added) {
        Map<String, VariableSpec> globals = new LinkedHashMap<>();
        project.globals().forEach(global -> globals.put(global.name(), global));
        added.forEach(variable -> globals.put(variable.name(), variable));
        return new Project(
                project.id(),
                project.name(),
                project.domain(),
                List.copyOf(globals.values()),
                project.missionTree(),
                project.plans(),
                project.schema(),
                project.importedFrom());
    }
}

package org.sami.spn.model;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A project: plans of one domain, with the variables they share.
 *
 * @param domain id of the vocabulary
 * @param missionTree roots of the tree in which the plans are shown
 * @param schema the JSON Schema that the project's file names for editors; it means nothing here and is kept
 * @param importedFrom where it came from, if not from an author's hand
 */
public record Project(
        String id,
        String name,
        String domain,
        List<VariableSpec> globals,
        List<MissionTreeNode> missionTree,
        List<Plan> plans,
        Optional<String> schema,
        Optional<ImportOrigin> importedFrom) {
    public Project {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(domain, "domain");
        globals = List.copyOf(globals);
        missionTree = List.copyOf(missionTree);
        plans = List.copyOf(plans);
        Objects.requireNonNull(schema, "schema");
        Objects.requireNonNull(importedFrom, "importedFrom");
    }

    /** A project whose file names no JSON Schema, and that was not imported. */
    public Project(
            String id,
            String name,
            String domain,
            List<VariableSpec> globals,
            List<MissionTreeNode> missionTree,
            List<Plan> plans) {
        this(id, name, domain, globals, missionTree, plans, Optional.empty(), Optional.empty());
    }

    /** The plan of that id. */
    public Optional<Plan> plan(String planId) {
        return plans.stream().filter(p -> p.id().equals(planId)).findFirst();
    }

    /** The same project with another name. */
    public Project withName(String name) {
        return new Project(id, name, domain, globals, missionTree, plans, schema, importedFrom);
    }

    /** The same project with other globals. */
    public Project withGlobals(List<VariableSpec> globals) {
        return new Project(id, name, domain, globals, missionTree, plans, schema, importedFrom);
    }

    /** The same project with another mission tree. */
    public Project withMissionTree(List<MissionTreeNode> missionTree) {
        return new Project(id, name, domain, globals, missionTree, plans, schema, importedFrom);
    }

    /** The same project with other plans. */
    public Project withPlans(List<Plan> plans) {
        return new Project(id, name, domain, globals, missionTree, plans, schema, importedFrom);
    }

    /** The same project with another origin. */
    public Project withImportedFrom(Optional<ImportOrigin> importedFrom) {
        return new Project(id, name, domain, globals, missionTree, plans, schema, importedFrom);
    }
}

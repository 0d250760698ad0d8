package org.sami.crw.sim.run.record;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * Identifies a plan by its content: SHA-256 of the canonical text of the plan, of its sub-mission plans and of the project's variables. Equal plans
 * have equal hashes, whatever their file, layout and the other plans in the file are.
 */
final class PlanHash {
    private PlanHash() {}

    static String of(RunPlan run) {
        Project project = run.project();
        Set<String> ran = new LinkedHashSet<>();
        add(project, run.plan(), ran);
        List<Plan> plans =
                ran.stream().map(id -> project.plan(id).orElseThrow()).toList();
        Project part =
                new Project(run.plan().id(), run.plan().title(), project.domain(), project.globals(), List.of(), plans);
        byte[] text = new ProjectWriter(run.vocabulary()).text(part).getBytes(StandardCharsets.UTF_8);
        return HexFormat.of().formatHex(RunHash.sha256().digest(text));
    }

    private static void add(Project project, Plan plan, Set<String> ran) {
        if (ran.add(plan.id())) {
            plan.places().stream()
                    .flatMap(place -> place.subMissions().stream())
                    .forEach(child -> project.plan(child.plan()).ifPresent(p -> add(project, p, ran)));
        }
    }
}

package org.sami.domain.mistake;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditResult;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * The right plans in which mistakes are made: those of the library, those of the deployment at Katara beach (ids after {@code katara/}),
 * {@code watched}, an exploration whose batteries are watched, and {@code sampled}, which reads a sensor where the panoramas take pictures.
 */
final class RightPlans {
    static final String WATCHED = "explore-area+battery";
    static final String SAMPLED = "panorama+sensor";
    static final String KATARA = "katara/";
    static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private static final Path BEACH = Path.of("src/main/resources/org/sami/domain/crw/deployments/katara-beach.json");
    private static final Map<String, Project> PROJECTS = projects();

    private RightPlans() {}

    private static Map<String, Project> projects() {
        Map<String, Project> projects = new LinkedHashMap<>();
        LIBRARY.projects().values().forEach(project -> project.plans().forEach(p -> projects.put(p.id(), project)));
        Project beach = new ProjectReader(LIBRARY.vocabulary()).read(BEACH).orThrow();
        beach.plans().forEach(p -> projects.put(KATARA + p.id(), beach));
        projects.put(WATCHED, watched(projects.get("explore-area")));
        projects.put(SAMPLED, sampled(projects.get("panorama")));
        return projects;
    }

    /** The project that holds a plan. */
    static Project of(String plan) {
        return PROJECTS.get(plan);
    }

    /** The id of a plan within its project. */
    static String id(String plan) {
        return plan.startsWith(KATARA)
                ? plan.substring(KATARA.length())
                : plan.contains("+") ? plan.substring(0, plan.indexOf('+')) : plan;
    }

    static Set<String> names() {
        return PROJECTS.keySet();
    }

    /** A project after an edit that is not refused. */
    static Project after(Project project, Edit edit) {
        EditResult result = edit.apply(project, LIBRARY.vocabulary());
        assertThat(result).as("%s", result).isInstanceOf(EditResult.Done.class);
        return result.project().orElseThrow();
    }

    private static Project watched(Project project) {
        PlanEdits on = new PlanEdits("explore-area");
        Map<String, Value> levels = new LinkedHashMap<>();
        levels.put("low", new RealValue(30));
        levels.put("critical", new RealValue(15));
        return after(
                project,
                PlanEdits.all(
                        on.output("explore", "levels", "BatteryLevelSubscription", levels),
                        on.transition("weak"),
                        on.input("weak", "weak-battery", "BatteryLow"),
                        on.connectIn("explore", "weak", "relevant all"),
                        on.connectOut("weak", "failed", "take all relevant"),
                        on.transition("empty"),
                        on.input("empty", "empty-battery", "BatteryCritical"),
                        on.connectIn("explore", "empty", "relevant all"),
                        on.connectOut("empty", "failed", "take all relevant")));
    }

    private static Project sampled(Project project) {
        PlanEdits on = new PlanEdits("panorama");
        return after(
                project,
                PlanEdits.all(
                        on.remove("take"),
                        on.output("panorama", "read", "TakeMeasurement", Map.of("sensor", new TextValue("oxygen"))),
                        on.waitsFor("picture", "MeasurementTaken"),
                        on.waitsFor("no-picture", "MeasurementFailed")));
    }
}

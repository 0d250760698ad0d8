package org.sami.crw.sim.run.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.sim.run.TestRuns;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

class PlanHashTest {
    private static final RunPlan SAMPLE = TestRuns.sample();

    @Test
    void otherPlansOfTheProjectDoNotChangeIt() {
        Project project = SAMPLE.project();
        List<Plan> more = new ArrayList<>(TestRuns.plan("clv").project().plans());
        more.addAll(project.plans());
        Project larger =
                new Project("other", "Other", project.domain(), project.globals(), project.missionTree(), more);

        assertThat(PlanHash.of(new RunPlan(SAMPLE.vocabulary(), larger, SAMPLE.plan())))
                .isEqualTo(PlanHash.of(SAMPLE))
                .matches("[0-9a-f]{64}");
    }

    @Test
    void aChangeInASubMissionChangesIt() {
        String text = TestRuns.text("sample-project.json");
        String changed = text.replaceFirst("(\"id\": \"leg\",\\s*\"name\": \")", "$1other ");
        Project project = new ProjectReader(SAMPLE.vocabulary()).read(changed).orThrow();
        RunPlan plan =
                new RunPlan(SAMPLE.vocabulary(), project, project.plan("sample").orElseThrow());

        assertThat(changed).isNotEqualTo(text);
        assertThat(PlanHash.of(plan)).isNotEqualTo(PlanHash.of(SAMPLE));
    }
}

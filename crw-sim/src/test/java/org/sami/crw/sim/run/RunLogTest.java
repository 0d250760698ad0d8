package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.crw.report.OperatorAction;
import org.sami.crw.report.OperatorActionsPart;
import org.sami.crw.report.PhaseResult;
import org.sami.crw.report.PhasesPart;
import org.sami.crw.report.ReportText;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.RunPlan;

/** The phase chart and the operator's log of a run, in its report. */
class RunLogTest {
    private final RunPlan plan = TestRuns.plan("measure");
    private final RunReport report = TestRuns.run(plan, TestRuns.settings(plan, 3, 6, 5));

    @Test
    void reportSaysWhichActionsOfThePhaseChartWereExecuted() {
        assertThat(report.part(PhasesPart.class).orElseThrow().actions())
                .isNotEmpty()
                .extracting(PhaseResult::plan)
                .contains("measure");
        assertThat(report.part(PhasesPart.class).orElseThrow().actions())
                .anyMatch(action -> action.status().equals("done") && action.executions() > 0)
                .noneMatch(action -> action.status().equals("active"));
        assertThat(ReportText.text(report)).contains("phases\n  mission 1, ");
    }

    @Test
    void reportHasWhatTheOperatorDid() {
        assertThat(report.part(OperatorActionsPart.class).orElseThrow().actions())
                .extracting(OperatorAction::kind)
                .filteredOn(kind -> kind.equals("answer"))
                .hasSize((int) report.decisions().stream()
                        .filter(decision -> decision.by().equals("operator"))
                        .count());
        assertThat(report.part(OperatorActionsPart.class)
                        .orElseThrow()
                        .actions()
                        .get(0)
                        .text())
                .startsWith("started measure as mission 1");
    }
}

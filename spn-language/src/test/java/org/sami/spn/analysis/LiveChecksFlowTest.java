package org.sami.spn.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** What an edit of one plan lets come into others is looked at again in those, also in plans that neither run it nor are run by it. */
class LiveChecksFlowTest {
    /** First runs one sub-mission with whom it has, then another with whom the first brings back. */
    private static final Plan PARENT = new NetBuilder("parent")
            .start("s")
            .sub("s", "first")
            .transition("next")
            .in("s", "next", "always")
            .out("next", "b", "take all sub")
            .sub("b", "second")
            .build();

    /** Asks for relevant tokens without an event: a check offers to ask for tasks where tasks can come. */
    private static final Plan SECOND = new NetBuilder("second")
            .start("c")
            .end("e")
            .transition("t")
            .in("c", "t", "relevant all")
            .out("t", "e", "take all any")
            .build();

    private static Plan first(String moved) {
        return new NetBuilder("first")
                .start("c")
                .end("e")
                .transition("t", "SubMissionAborted")
                .in("c", "t", "any >= 1")
                .out("t", "e", moved)
                .build();
    }

    private static List<String> fixes(LiveChecks checks) {
        return checks.findings().stream()
                .filter(finding -> finding.plan().equals("second"))
                .flatMap(finding -> finding.fixes().stream())
                .map(fix -> fix.label())
                .toList();
    }

    @Test
    void siblingOfASubMissionThatBringsOthersBackIsCheckedAgain() {
        Project robots = NetBuilder.project(PARENT, first("take all any"), SECOND);
        Project tasks = robots.withPlans(List.of(
                robots.plans().get(0), first("add all relevant"), robots.plans().get(2)));
        LiveChecks before = LiveChecks.of(robots, TestVocabulary.TEST);

        assertThat(fixes(before)).doesNotContain("Ask for tasks");
        assertThat(fixes(before.after(tasks)))
                .contains("Ask for tasks")
                .isEqualTo(fixes(LiveChecks.of(tasks, TestVocabulary.TEST)));
        assertThat(fixes(before.after(tasks).after(robots))).isEqualTo(fixes(before));
    }
}

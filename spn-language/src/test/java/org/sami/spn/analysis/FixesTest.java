package org.sami.spn.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.Fix;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;

/** Every edit that a finding offers takes the finding away and adds no error. */
class FixesTest {
    private static final Set<String> MENDED = Set.of(
            "E-DANGLING",
            "E-END-GOES-ON",
            "E-FIELD-MISSING",
            "E-FIELD-TYPE",
            "E-NO-CAUSE",
            "E-NO-REQUIREMENT",
            "E-NO-START",
            "E-NO-SUB-MISSION",
            "E-NO-TIMEOUT",
            "E-RELEVANT-WITHOUT-EVENT",
            "E-START-IS-END",
            "E-TASK-FIELD",
            "E-TWO-STARTS",
            "E-UNKNOWN-EVENT",
            "E-UNKNOWN-FIELD",
            "E-UNKNOWN-PLAN",
            "E-UNKNOWN-TASK",
            "E-VARIABLE-TYPE",
            "E-VARIABLE-UNKNOWN",
            "E-DRAWN-BY-AUTONOMY",
            "W-COMMAND-AT-END",
            "W-EMPTY-POOL",
            "W-EMPTY-QUESTION",
            "W-ENDS-NOTHING",
            "W-ENDS-WITH-FIRST",
            "W-FIXED-NUMBER",
            "W-FRACTION",
            "W-NO-AUTOMATIC-ANSWER",
            "W-NOT-ABOVE",
            "W-OPEN-GATE",
            "W-PLACE-FORGOTTEN",
            "W-UNKNOWN-WORD",
            "W-VARIABLE-UNREAD",
            "W-WAITS-FOR-NOTHING");

    static List<PlanCheckCase> cases() {
        List<PlanCheckCase> cases = new ArrayList<>(PlanCheckCases.all());
        cases.add(bad(
                "E-NO-START", begun().end("end").in("go", "t", "generic >= 1").out("t", "end", "take all any")));
        cases.add(bad(
                "W-EMPTY-POOL", begun().start("start").transition("t", "News").out("t", "go", "take 1 generic")));
        cases.add(bad(
                "E-UNKNOWN-PLAN",
                begun().start("start")
                        .end("end")
                        .sub("go", "nothing")
                        .in("go", "t", "generic >= 1")
                        .out("t", "end")));
        return cases;
    }

    private static NetBuilder begun() {
        return new NetBuilder("plan");
    }

    private static PlanCheckCase bad(String code, NetBuilder net) {
        Project project = NetBuilder.project(net.build());
        return new PlanCheckCase(code, project, project);
    }

    @ParameterizedTest
    @MethodSource("cases")
    void fixTakesItsFindingAwayAndAddsNoError(PlanCheckCase one) {
        List<Finding> before = PlanChecks.check(one.bad(), CheckWords.WORDS);
        for (Finding finding : before) {
            for (Fix fix : finding.fixes()) {
                EditResult result = fix.edit().apply(one.bad(), CheckWords.WORDS);

                assertThat(result).as("%s of %s", fix, finding).isInstanceOf(EditResult.Done.class);
                List<Finding> after = checked(result.project().orElseThrow());
                assertThat(after)
                        .as("after %s of %s", fix, finding)
                        .noneMatch(f ->
                                f.code().equals(finding.code()) && f.message().equals(finding.message()));
                assertThat(errors(before)).as("after %s of %s", fix, finding).containsAll(errors(after));
            }
        }
    }

    @Test
    void findingsThatAreMechanicalOfferAFix() {
        Set<String> mended = new TreeSet<>();
        cases().stream()
                .flatMap(one -> checked(one.bad()).stream())
                .filter(finding -> !finding.fixes().isEmpty())
                .forEach(finding -> mended.add(finding.code()));

        assertThat(mended).containsAll(MENDED);
    }

    private static List<Finding> checked(Project project) {
        return PlanChecks.check(project, CheckWords.WORDS);
    }

    /** Errors by code and message: their places in the document may move. */
    private static List<String> errors(List<Finding> findings) {
        return findings.stream()
                .filter(Finding::isError)
                .map(f -> f.code() + " " + f.message())
                .toList();
    }
}

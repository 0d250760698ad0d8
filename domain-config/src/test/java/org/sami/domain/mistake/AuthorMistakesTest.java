package org.sami.domain.mistake;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Project;
import org.sami.spn.statespace.DeepChecks;
import org.sami.spn.statespace.DeepFinding;
import org.sami.spn.statespace.DeepRequest;
import org.sami.spn.statespace.SearchWatch;

/** Mistakes of authors, sixty and more: each is found by name at the right element, and none where a plan is right. */
@Tag("long")
class AuthorMistakesTest {
    private static final int MISTAKES = 60;
    private static final int MOST_MISSED = 3;
    private static final int STATES = 400;
    private static final Path DOCUMENT = Path.of("../docs/plan-checks.md");

    static List<AuthorMistake> mistakes() {
        List<AuthorMistake> all = new ArrayList<>(ValueMistakes.all());
        all.addAll(TeamMistakes.all());
        all.addAll(NetMistakes.all());
        return all;
    }

    static Set<String> rightPlans() {
        return RightPlans.names();
    }

    @ParameterizedTest
    @MethodSource("mistakes")
    void mistakeIsFoundByNameAtItsElement(AuthorMistake mistake) {
        Project wrong = RightPlans.after(RightPlans.of(mistake.plan()), mistake.edit());
        List<Finding> found = mistake.deep() ? deep(wrong, mistake) : live(wrong, mistake);

        if (mistake.isFound()) {
            assertThat(found)
                    .as("%s", found)
                    .anyMatch(
                            f -> f.code().equals(mistake.code()) && f.elements().contains(mistake.element()));
        } else {
            assertThat(found).isEmpty();
        }
    }

    private static List<Finding> live(Project project, AuthorMistake mistake) {
        return PlanChecks.check(project, RightPlans.LIBRARY.vocabulary(), RightPlans.id(mistake.plan()));
    }

    private static List<Finding> deep(Project project, AuthorMistake mistake) {
        DeepRequest request = new DeepRequest(
                project, RightPlans.LIBRARY.vocabulary(), RightPlans.id(mistake.plan()), List.of("b1", "b2"), STATES);
        return DeepChecks.ALL.stream()
                .flatMap(check -> check.run(request, SearchWatch.NONE).findings().stream())
                .map(DeepFinding::finding)
                .toList();
    }

    @ParameterizedTest
    @MethodSource("rightPlans")
    void rightPlanHasNoFinding(String plan) {
        assertThat(PlanChecks.check(RightPlans.of(plan), RightPlans.LIBRARY.vocabulary()))
                .isEmpty();
    }

    @Test
    void atLeastSixtyMistakesHaveNamesOfTheirOwnAndMostAreFound() {
        assertThat(mistakes()).extracting(AuthorMistake::name).doesNotHaveDuplicates();
        assertThat(mistakes()).hasSizeGreaterThanOrEqualTo(MISTAKES);
        assertThat(mistakes().stream().filter(mistake -> !mistake.isFound()).count())
                .isLessThanOrEqualTo(MOST_MISSED);
    }

    /** With {@code -PcanonicalWrite} the table is put into the page instead. */
    @Test
    void pageSaysWhichCodeFindsEach() throws IOException {
        String table = mistakes().stream()
                .map(m -> "| " + m.name() + " | "
                        + (m.isFound() ? "`" + m.code() + "`" + (m.deep() ? ", deep" : "") : "not found") + " |\n")
                .collect(Collectors.joining("", "| mistake | found by |\n|---|---|\n", ""));
        String page = Files.readString(DOCUMENT);
        if (Boolean.getBoolean("canonical.write")) {
            int begin = page.indexOf("| mistake |");
            int end = page.indexOf("\n\n", begin) + 1;
            Files.writeString(DOCUMENT, page.substring(0, begin) + table + page.substring(end));
        } else {
            assertThat(page).contains(table);
        }
    }
}

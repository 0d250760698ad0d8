package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.testcase.TestCaseRunner;

/** A library for one beach (thesis 6.3.1): the plans of the domain's library, with the boats and areas of that place as globals. */
class DeploymentTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Path FILE = Path.of("src/main/resources/org/sami/domain/crw/deployments/katara-beach.json");

    private Project beach;

    @BeforeEach
    void read() {
        beach = new ProjectReader(LIBRARY.vocabulary()).read(FILE).orThrow();
    }

    @Test
    void itPassesAllChecksAndItsSavedCases() {
        assertThat(PlanChecks.check(beach, LIBRARY.vocabulary())).isEmpty();
        TestCaseRunner runner = new TestCaseRunner(beach, LIBRARY.vocabulary());
        for (Plan plan : beach.plans()) {
            for (TestCase test : plan.testCases()) {
                assertThat(runner.run(plan, test)).as(test.name()).isEmpty();
            }
        }
    }

    /** What is mended in the library is mended here. */
    @Test
    void itsNetsAreThoseOfTheLibrary() {
        for (Plan plan : beach.plans()) {
            Plan original = LIBRARY.projectOf(plan.id())
                    .flatMap(project -> project.plan(plan.id()))
                    .orElseThrow();

            assertThat(plan.inEdges()).as(plan.id()).isEqualTo(original.inEdges());
            assertThat(plan.outEdges()).as(plan.id()).isEqualTo(original.outEdges());
            assertThat(plan.places()).extracting(Place::id).containsExactlyElementsOf(ids(original));
            assertThat(plan.transitions())
                    .extracting(Transition::id)
                    .containsExactlyElementsOf(
                            original.transitions().stream().map(Transition::id).toList());
        }
    }

    private static Iterable<String> ids(Plan plan) {
        return plan.places().stream().map(Place::id).toList();
    }

    @Test
    void boatsAreasAndPlacesAreGlobalsThatNoPlanHides() {
        Set<String> globals = beach.globals().stream().map(VariableSpec::name).collect(Collectors.toSet());

        assertThat(globals).contains("@boats", "@water", "@noGo", "@home", "@station", "@safePlace");
        assertThat(beach.globals()).allMatch(global -> global.initial().isPresent());
        assertThat(beach.plans())
                .flatExtracting(Plan::variables)
                .extracting(VariableSpec::name)
                .doesNotContainAnyElementsOf(globals);
    }
}

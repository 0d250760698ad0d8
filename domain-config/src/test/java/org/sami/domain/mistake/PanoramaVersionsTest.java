package org.sami.domain.mistake;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.edit.Edit;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;

/** The panorama plans of the thesis (9.1.2) as authors drew them from nothing, and their wrong versions; skipped where the files are absent. */
class PanoramaVersionsTest {
    private static final String RIGHT = "panorama-T5c-sync-right";
    private static final String START = "operator-create-locations";
    private static final PlanEdits ON = new PlanEdits("plan");

    private static Project read(String name) {
        Path file = Path.of("../../shared/found", name + ".json");
        assumeTrue(Files.exists(file), "skipped: " + file + " is not here");
        return new ProjectReader(RightPlans.LIBRARY.vocabulary()).read(file).orThrow();
    }

    private static List<Finding> check(Project project) {
        return PlanChecks.check(project, RightPlans.LIBRARY.vocabulary());
    }

    @ParameterizedTest
    @ValueSource(strings = {"panorama-T1-async", RIGHT})
    void rightVersionHasNoFinding(String name) {
        assertThat(check(read(name))).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = "panorama-T5a-sync-at-least-1")
    void versionThatDoesNotWaitIsFound(String name) {
        assertThat(check(read(name))).extracting(Finding::code).containsExactly("W-OPEN-GATE");
    }

    static Stream<Arguments> wrong() {
        return Stream.of(
                version("= 3", "W-FIXED-NUMBER", "go2", ON.in(in("ready", "go2"), "task == 3")),
                version("forgotten zero", "W-OPEN-GATE", "go2", ON.remove(in("place-6", "go2"))),
                version("end forgets a place", "W-PLACE-FORGOTTEN", "place-7", ON.remove(in("place-7", "allfin"))),
                version("end forgets who waits", "W-PLACE-FORGOTTEN", "place-4", ON.remove(in("place-4", "allfin"))),
                version("ends with the first", "W-ENDS-WITH-FIRST", "completed", lead("completed", "fin", "end")),
                version("back to the start", "W-TASKS-MADE-AGAIN", "completed", lead("completed", "fin", START)),
                version("back to the work", "W-GOES-ROUND", "place-6", lead("rested", "done", "place-6")),
                version("task in the wrong field", "E-TASK-FIELD", "rest", ON.readsTask("rest", "duration")),
                version(
                        "options applied",
                        "E-VARIABLE-TYPE",
                        "place-4.ApplyAllocation",
                        ON.reads("place-4.ApplyAllocation", "allocation", "@options")),
                version(
                        "applied unchosen",
                        "W-NOT-YET-WRITTEN",
                        "place-4",
                        lead("allocation-response", "place-3", "place-4")));
    }

    private static Arguments version(String name, String code, String element, Edit edit) {
        return Arguments.of(name, code, element, edit);
    }

    /** The id of an edge from a place to a transition. */
    private static String in(String place, String transition) {
        return read(RIGHT).plans().get(0).inEdges().stream()
                .filter(e -> e.place().equals(place) && e.transition().equals(transition))
                .findFirst()
                .orElseThrow()
                .id();
    }

    private static Edit lead(String transition, String from, String to) {
        String edge = read(RIGHT).plans().get(0).outEdges().stream()
                .filter(e -> e.transition().equals(transition) && e.place().equals(from))
                .findFirst()
                .orElseThrow()
                .id();
        return ON.redirect(edge, transition, to, "take all relevant");
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("wrong")
    void wrongVersionIsFoundByNameBeforeItIsRun(String name, String code, String element, Edit edit) {
        assertThat(check(RightPlans.after(read(RIGHT), edit)))
                .as(name)
                .anyMatch(f -> f.code().equals(code) && f.elements().contains(element));
    }
}

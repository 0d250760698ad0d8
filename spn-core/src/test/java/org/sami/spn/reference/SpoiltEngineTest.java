package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The differential test notices when one rule of the engine is wrong: each row spoils one line of its source. */
class SpoiltEngineTest {
    private static final int MOST_SEEDS = 8000;

    static Stream<Arguments> rules() {
        return Stream.of(
                arguments(
                        "the loser of a conflict fires too",
                        "Firing.java",
                        "rules.enabling.isEnabled(t, Relevant.NOBODY, Scope.FREE) && mayFire(t)",
                        "mayFire(t)"),
                arguments(
                        "less than inhibits the wrong way",
                        "Enabling.java",
                        "case LESS_THAN -> n < r.n();",
                        "case LESS_THAN -> n >= r.n();"),
                arguments(
                        "exactly is at least",
                        "Enabling.java",
                        "case EXACTLY -> n == r.n();",
                        "case EXACTLY -> n >= r.n();"),
                arguments(
                        "timers are not cancelled",
                        "Timers.java",
                        "for (Timer t : sent.timers) {",
                        "for (Timer t : java.util.List.<Timer>of()) {"),
                arguments(
                        "a visit by nobody does not end without input event",
                        "Firing.java",
                        "(!t.hasInputs() || t.clears",
                        "(t.clears"),
                arguments(
                        "who left is not struck from pending answers",
                        "Pendings.java",
                        "if (t != null && t.pending > 0) {",
                        "if (t != null && t.pending < 0) {"),
                arguments(
                        "an answer survives its visit",
                        "Pendings.java",
                        "if (p.names.length == 0 && p.visit() == visit) {",
                        "if (p.names.length < 0 && p.visit() == visit) {"),
                arguments(
                        "news are not replaced by newer ones",
                        "Pendings.java",
                        "if (p.isNews() && !p.input.isPress()) {",
                        "if (p.isNews() && p.input.isPress()) {"),
                arguments(
                        "nobody looks at inhibited transitions when tokens leave",
                        "WorkList.java",
                        "if (t.hasInputs() || t.inhibitedBy(place.place.index)) {",
                        "if (t.hasInputs()) {"),
                arguments(
                        "an edge adds a token at each requirement",
                        "Selection.java",
                        "e.addedBy = edge;",
                        "e.addedBy = 0;"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("rules")
    void disagreesSoon(String rule, String file, String right, String wrong, @TempDir Path folder) {
        Differential.Maker spoilt = SpoiltEngine.with(folder, file, right, wrong);

        Optional<Differential.Disagreement> found = Optional.empty();
        for (long seed = 1; seed <= MOST_SEEDS && found.isEmpty(); seed++) {
            found = Differential.explore(seed, Scenario.LENGTH, spoilt);
        }

        assertThat(found).as(rule).isPresent();
    }
}

package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The comparison of nets that follow sub-missions with the engine notices when one line of that translation is wrong: each row spoils one. */
@Tag("long")
class SpoiltChildTest {
    private static final Path PLANS = Path.of("../spn-authoring/src/main/java/org/sami/spn/plannet");
    private static final int LEAST_SPOILT = 18;
    private static final int MOST_SEEDS = 1000;
    private static final SpoiltNets NETS = new SpoiltNets(ChildJudge.class, MOST_SEEDS);

    /** What is spoilt, and the line. */
    static Stream<Arguments> lines() {
        return Stream.of(
                child("those who enter do not start", "arcs.add(at, entering);", "arcs.add(at, 0);"),
                child("a child does not run", "arcs.add(mission.places().running(), 1);", ""),
                child(
                        "a child's own rules do not look at the start",
                        "child.occasions(",
                        "if (false) child.occasions("),
                visit("a completion is not known", "arcs.set(complete);", ""),
                child("nobody comes back", "if (brought.contains(token)) {", "if (false) {"),
                child("all come back", "if (brought.contains(token)) {", "if (true) {"),
                visit("a second visit is the first one", "second.atLeast(at, 1);", "second.atLeast(at, 9);"),
                visit("a second visit changes nothing", "leaveOpen(second);", ""),
                visit("who waits for a completion does not", "arcs.atLeast(complete, 1)", "arcs.atLeast(complete, 0)"),
                visit("somebody may be where nobody is", "-> arcs.below(at, 1)", "-> arcs.below(at, 9)"),
                visit("no completion is new", "arcs.set(unused);", ""),
                plan("a number takes all that came back", "TokenOptions", "s.requirement().n() >= least", "true"),
                cases(
                        "nobody completes",
                        "for (SubMode mode : child.get().modes()) {",
                        "for (SubMode mode : new SubMode[] {SubMode.VACANT, SubMode.OPEN}) {"),
                cases(
                        "no place is vacant",
                        "for (SubMode mode : child.get().modes()) {",
                        "for (SubMode mode : new SubMode[] {SubMode.COMPLETE, SubMode.OPEN}) {"),
                cases("who did not come back is taken", "option.arcs.atLeast(at, 1);", ""),
                cases("who came back may stay", "option.arcs.below(at, 1);", ""),
                cases("who never came back must", "option.arcs.below(at, 1);", "option.arcs.atLeast(at, 1);"),
                plan("an end does not end a child", "FiringEffects", "child.completed(one, atEnd)", "child.start(one)"),
                plan(
                        "a child outlives its parent",
                        "FiringEffects",
                        "arcs.atLeast(of.get().places().running(), 1);",
                        ""),
                plan(
                        "a child is held when it is complete",
                        "PossibleTokens",
                        "mode == SubMode.OPEN);",
                        "mode != SubMode.VACANT);"),
                plan(
                        "no event waits for an empty place",
                        "WakenedCases",
                        "before.atLeast(heard, 1);",
                        "before.atLeast(heard, 2);"));
    }

    private static Arguments child(String spoilt, String right, String wrong) {
        return plan(spoilt, "FollowedChild", right, wrong);
    }

    private static Arguments visit(String spoilt, String right, String wrong) {
        return plan(spoilt, "VisitChild", right, wrong);
    }

    private static Arguments cases(String spoilt, String right, String wrong) {
        return plan(spoilt, "SubMissionCases", right, wrong);
    }

    private static Arguments plan(String spoilt, String source, String right, String wrong) {
        return arguments(spoilt, PLANS.resolve(source + ".java"), right, wrong);
    }

    @Test
    void manyLinesAreSpoilt() {
        assertThat(lines()).hasSizeGreaterThanOrEqualTo(LEAST_SPOILT);
        assertThat(lines().map(row -> row.get()[0])).doesNotHaveDuplicates();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("lines")
    void disagreesSoon(String spoilt, Path source, String right, String wrong, @TempDir Path folder)
            throws ReflectiveOperationException {
        assertThat(NETS.difference(spoilt, folder, source, right, wrong))
                .as(spoilt)
                .isPresent();
    }
}

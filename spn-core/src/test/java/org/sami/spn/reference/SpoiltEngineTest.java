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
                        "for (RunningTimer t : sent.timers) {",
                        "for (RunningTimer t : java.util.List.<RunningTimer>of()) {"),
                arguments(
                        "a visit by nobody does not end without input event",
                        "Firing.java",
                        "(!t.hasInputs() || t.clears",
                        "(t.clears"),
                arguments(
                        "who left is not struck from pending answers",
                        "PendingOccurrences.java",
                        "if (t != null && t.pending > 0) {",
                        "if (t != null && t.pending < 0) {"),
                arguments(
                        "an answer survives its visit",
                        "PendingOccurrences.java",
                        "if (p.names.length == 0 && p.visit() == visit) {",
                        "if (p.names.length < 0 && p.visit() == visit) {"),
                arguments(
                        "news are not replaced by newer ones",
                        "PendingOccurrences.java",
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
                        "e.addedBy = 0;"),
                arguments(
                        "commands are not withdrawn at an end place",
                        "Firing.java",
                        "rules.missionEnd.lastWords(m);",
                        ";"),
                arguments(
                        "a robot that is pulled stays in grandchildren",
                        "RobotRemoval.java",
                        "rules.leaving.left(e, before, true);",
                        "rules.leaving.left(e, before, false);"),
                arguments(
                        "who is put back into a place stands in its static instance twice",
                        "SharedInstances.java",
                        "(oldest != null && oldest.order <= before)",
                        "oldest != null"),
                arguments(
                        "who returned from a static instance is still expected back",
                        "SharedInstances.java",
                        "tokens.forEach(instance.starting::remove);",
                        ";"),
                arguments(
                        "tokens that enter while parameters are asked are lost",
                        "SharedInstances.java",
                        "child.addWaiting(tokens);",
                        ";"),
                arguments(
                        "a child writes its own variable where its parent declares it",
                        "Variables.java",
                        "if (declaration != null) {",
                        "if (declaration != null && m == mission) {"),
                arguments(
                        "a child's own tasks return",
                        "SubMissions.java",
                        "own.original == null ? null : new Token.Task(own.original.id)",
                        "own.original == null ? token : new Token.Task(own.original.id)"),
                arguments(
                        "autonomy's answer counts as the operator's",
                        "Decisions.java",
                        "take(open, automatic.get(), Answerer.AUTONOMY);",
                        "take(open, automatic.get(), Answerer.OPERATOR);"),
                arguments(
                        "a robot's timer goes on when it leaves",
                        "Timers.java",
                        "sent.timers.removeIf(t -> t.token().equals(token) && rules.state.timers.remove(t));",
                        ";"),
                arguments(
                        "an aborted child counts as finished",
                        "MissionEnd.java",
                        "if (outcome == Outcome.ABORTED) {",
                        "if (outcome == Outcome.HALTED) {"),
                arguments("a dropped robot keeps its tasks", "TaskAllocation.java", "task.allocate(\"\");", ";"),
                arguments(
                        "interrupts leave commands in force",
                        "Firing.java",
                        "if (!robots.isEmpty()) {",
                        "if (robots.isEmpty()) {"),
                arguments(
                        "a return value is told to nobody",
                        "SubMissions.java",
                        "if (input.checks(r.value)) {",
                        "if (!input.checks(r.value)) {"),
                arguments(
                        "the value of a return that was used is checked",
                        "SharedInstances.java",
                        "rules.pendings.over(r);",
                        ";"),
                arguments(
                        "nobody hears of the start marking and of other entries",
                        "Visits.java",
                        "rules.emit(new Effect.Entered(place.mission.id, place.place.id(), v.id, v.entered));",
                        ";"),
                arguments(
                        "nobody hears that nobody left",
                        "Visits.java",
                        "rules.emit(new Effect.Left(place.mission.id, place.place.id(), v.id, List.of()));",
                        ";"),
                arguments(
                        "the second token that leaves a visit is not told of",
                        "Leaving.java",
                        "tokens.add(entries.get(i).token);",
                        "if (tokens.isEmpty()) { tokens.add(entries.get(i).token); }"),
                arguments(
                        "tokens are said to leave another visit of the place",
                        "Leaving.java",
                        "place.place.id(), v.id, tokens",
                        "place.place.id(), v.id + 1, tokens"),
                arguments(
                        "a drop takes tokens without a word",
                        "RobotRemoval.java",
                        "rules.leaving.remove(removed);",
                        "removed.forEach(e -> e.place.remove(e));"),
                arguments(
                        "a return takes tokens without a word",
                        "SharedInstances.java",
                        "rules.leaving.remove(entries);",
                        "entries.forEach(e -> e.place.remove(e));"),
                arguments(
                        "a firing tells moves that it does not make",
                        "Selection.java",
                        "result.moves.add(new TokenMove(token, Optional.empty(), out.place().inMoves));",
                        "result.moves.add(new TokenMove(token, out.place().inMoves, out.place().inMoves));"),
                arguments(
                        "a mapped task keeps its parent's name",
                        "SubMissions.java",
                        "if (own.original != null && own.original.id.equals(task.task())) {",
                        "if (own.original == null && own.id.equals(task.task())) {"));
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

package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The differential test notices when one rule of the engine is wrong: each row spoils one line of its source. */
@Tag("long")
class SpoiltEngineTest {
    private static final int LEAST_SPOILT = 50;
    private static final int MOST_SEEDS = 2000;

    /** The seeds that show what few sessions show: the search begins there, and goes on through all of them. Every build tries them. */
    static final Map<String, Long> RARE = Map.ofEntries(
            Map.entry("who is put back into a place stands in its static instance twice", 12L),
            Map.entry("values of two visits go together", 13L),
            Map.entry("an answer that names only who is gone is for those who ask for somebody", 17L),
            Map.entry("a check that names a plan hears of every plan's returns", 23L),
            Map.entry("exactly is at least", 27L),
            Map.entry("the value of a return that was used is checked", 27L),
            Map.entry("a mapped task keeps its parent's name", 27L),
            Map.entry("a dropped robot keeps its tasks", 28L),
            Map.entry("who is withdrawn from an instance is still offered there", 36L),
            Map.entry("a child writes its own variable where its parent declares it", 38L),
            Map.entry("who returned from a static instance is still expected back", 40L),
            Map.entry("values of two returns of a static instance go together", 43L),
            Map.entry("a filter whose last robot is dropped offers nobody", 44L),
            Map.entry("a filter whose last robot has left offers who is gone", 44L),
            Map.entry("a choice that is asked anew has no deadline", 48L),
            Map.entry("the deadline of a choice that is asked anew begins anew", 48L),
            Map.entry("a return is used up whoever else it names", 53L),
            Map.entry("returns go together in the order in which they came", 56L),
            Map.entry("who stands in the place of a visit by nobody is gone", 62L),
            Map.entry("a robot's timer goes on when it leaves", 100L),
            Map.entry("a child's own tasks return", 160L),
            Map.entry("a deadline that has passed is set again", 498L),
            Map.entry("a robot that is pulled stays in grandchildren", 627L),
            Map.entry("tokens that enter while parameters are asked are lost", 849L),
            Map.entry("a return value is told to nobody", 976L),
            Map.entry("what stays a return stands behind the later ones", 1576L),
            Map.entry("a declared variable without value is read from the parent", 1655L));

    /** The rule that is spoilt, how, and the line. */
    static Stream<Arguments> rules() {
        return Stream.of(
                arguments(
                        "R-IN-2",
                        "less than inhibits the wrong way",
                        "Enabling.java",
                        "case LESS_THAN -> n < r.n();",
                        "case LESS_THAN -> n >= r.n();"),
                arguments(
                        "R-IN-2",
                        "exactly is at least",
                        "Enabling.java",
                        "case EXACTLY -> n == r.n();",
                        "case EXACTLY -> n >= r.n();"),
                arguments(
                        "R-VIS-5",
                        "timers are not cancelled",
                        "Timers.java",
                        "for (RunningTimer t : sent.timers) {",
                        "for (RunningTimer t : java.util.List.<RunningTimer>of()) {"),
                arguments(
                        "R-VIS-4",
                        "a visit by nobody does not end without input event",
                        "Firing.java",
                        "(!t.hasInputs() || t.clears",
                        "(t.clears"),
                arguments(
                        "R-PEND-3",
                        "who left is not struck from pending answers",
                        "PendingOccurrences.java",
                        "if (t != null && t.pending > 0) {",
                        "if (t != null && t.pending < 0) {"),
                arguments(
                        "R-PEND-4",
                        "an answer survives its visit",
                        "PendingOccurrences.java",
                        "if (p.names.length == 0 && p.visit() == visit) {",
                        "if (p.names.length < 0 && p.visit() == visit) {"),
                arguments(
                        "R-PEND-2",
                        "news are not replaced by newer ones",
                        "PendingOccurrences.java",
                        "if (p.isNews() && !p.input.isPress()) {",
                        "if (p.isNews() && p.input.isPress()) {"),
                arguments(
                        "R-LOOK-2",
                        "nobody looks at inhibited transitions when tokens leave",
                        "FiringAgenda.java",
                        "if (t.hasInputs() || t.inhibitedBy(place.place.index)) {",
                        "if (t.hasInputs()) {"),
                arguments(
                        "R-OUT-6",
                        "an edge adds a token at each requirement",
                        "SelectedTokens.java",
                        "!made.contains(e.token) && addedByEdge.add(e)",
                        "!made.contains(e.token)"),
                arguments(
                        "R-END-4",
                        "commands are not withdrawn at an end place",
                        "Firing.java",
                        "rules.missionEnd.lastWords(m);",
                        ";"),
                arguments(
                        "R-INT-7",
                        "a robot that is pulled stays in grandchildren",
                        "RobotRemoval.java",
                        "rules.removal.left(e, before, true);",
                        "rules.removal.left(e, before, false);"),
                arguments(
                        "R-DEC-8",
                        "who is withdrawn from an instance is still offered there",
                        "Firing.java",
                        "rules.robotRemoval.askWithoutWithdrawn();",
                        ";"),
                arguments(
                        "R-SHR-7",
                        "who is put back into a place stands in its static instance twice",
                        "SharedInstances.java",
                        "(oldest != null && oldest.order() <= before)",
                        "oldest != null"),
                arguments(
                        "R-SHR-2",
                        "who returned from a static instance is still expected back",
                        "SharedInstances.java",
                        "tokens.forEach(instance.starting::remove);",
                        ";"),
                arguments(
                        "R-ACT-4",
                        "tokens that enter while parameters are asked are lost",
                        "SharedInstances.java",
                        "child.addWaiting(tokens);",
                        ";"),
                arguments(
                        "R-VAR-2",
                        "a child writes its own variable where its parent declares it",
                        "VariableScopes.java",
                        "if (declaration != null) {",
                        "if (declaration != null && m == mission) {"),
                arguments(
                        "R-SUB-7",
                        "a child's own tasks return",
                        "ChildTokens.java",
                        "own.original == null ? null : new Token.Task(own.original.id)",
                        "own.original == null ? token : new Token.Task(own.original.id)"),
                arguments(
                        "R-DEC-2",
                        "autonomy's answer counts as the operator's",
                        "Decisions.java",
                        "take(open, automatic.get(), Answerer.AUTONOMY);",
                        "take(open, automatic.get(), Answerer.OPERATOR);"),
                arguments(
                        "R-VIS-6",
                        "a robot's timer goes on when it leaves",
                        "Timers.java",
                        "sent.timers.removeIf(t -> t.token().equals(token) && step.state.timers.remove(t));",
                        ";"),
                arguments(
                        "R-SUB-10",
                        "an aborted child counts as finished",
                        "MissionEnd.java",
                        "if (outcome == Outcome.ABORTED) {",
                        "if (outcome == Outcome.HALTED) {"),
                arguments(
                        "R-TOK-6",
                        "a dropped robot keeps its tasks",
                        "TaskAllocation.java",
                        "task.allocate(\"\");",
                        ";"),
                arguments(
                        "R-INT-6",
                        "interrupts leave commands in force",
                        "Firing.java",
                        "if (!robots.isEmpty()) {",
                        "if (robots.isEmpty()) {"),
                arguments(
                        "R-RET-1",
                        "a return value is told to nobody",
                        "SubMissions.java",
                        "if (input.checks(r.value, r.instance.plan())) {",
                        "if (!input.checks(r.value, r.instance.plan())) {"),
                arguments(
                        "R-RET-1",
                        "a check that names a plan hears of every plan's returns",
                        "../net/CompiledInput.java",
                        "(checkedPlan == null || checkedPlan.equals(plan))",
                        "plan != null"),
                arguments(
                        "R-FIRE-2",
                        "the value of a return that was used is checked",
                        "SharedInstances.java",
                        "rules.pendings.over(r);",
                        ";"),
                arguments(
                        "R-OCC-12",
                        "who was gone before the answer came is waited for",
                        "PendingOccurrences.java",
                        "if (!n.stood && wasNamed(",
                        "if (n.struck && wasNamed("),
                arguments(
                        "R-OCC-12",
                        "who was offered because it stood there, and is gone, is waited for",
                        "PendingOccurrences.java",
                        "|| offered.contains(robot.proxy())",
                        ""),
                arguments(
                        "R-OCC-12",
                        "an answer that names only who is gone is for those who ask for somebody",
                        "Routing.java",
                        "if (sent != null && p.names.length == 0 &&",
                        "if (sent != null && !o.namesSomebody() &&"),
                arguments(
                        "R-OCC-12",
                        "an answer of the operator that names only who is gone closes its question",
                        "Decisions.java",
                        "if (namesOnlyGone(open, input.answer())) {",
                        "if (input == null) {"),
                arguments(
                        "R-OCC-12",
                        "who stands in the place of a visit by nobody is gone",
                        "PendingOccurrences.java",
                        "visit.byNobody ? visit.place.has(token) : !visit.ended && visit.has(token)",
                        "!visit.ended && visit.has(token)"),
                arguments(
                        "R-SHR-9",
                        "returns go together in the order in which they came",
                        "PairedReturns.java",
                        "return !common.isEmpty() ||",
                        "return chosen != null ||"),
                arguments(
                        "R-SHR-9",
                        "a return is used up whoever else it names",
                        "SharedInstances.java",
                        "if (!left.isEmpty()) {",
                        "if (left.size() < 0) {"),
                arguments(
                        "R-SHR-9",
                        "what stays a return stands behind the later ones",
                        "SharedInstances.java",
                        "returns.add(returns.indexOf(r) + 1, rest);",
                        "returns.add(rest);"),
                arguments(
                        "R-DEC-10",
                        "a filter whose last robot is dropped offers nobody",
                        "RobotChoices.java",
                        "if (tooFew(left, choice) && filtered(open)",
                        "if (open == null && filtered(open)"),
                arguments(
                        "R-DEC-10",
                        "a filter whose last robot has left offers who is gone",
                        "Firing.java",
                        "rules.robotChoices.left(m);",
                        ";"),
                arguments(
                        "R-DEC-8",
                        "a choice that is asked anew has no deadline",
                        "RobotChoices.java",
                        "open.deadline == null ? OptionalLong.empty() : before.deadlineMillis();",
                        "OptionalLong.empty();"),
                arguments(
                        "R-DEC-8",
                        "the deadline of a choice that is asked anew begins anew",
                        "RobotChoices.java",
                        "open.deadline == null ? OptionalLong.empty() : before.deadlineMillis();",
                        "open.deadline == null ? OptionalLong.empty()"
                                + " : OptionalLong.of(step.state.now + open.sent.output.timeoutMillis);"),
                arguments(
                        "R-DEC-8",
                        "a deadline that has passed is set again",
                        "RobotChoices.java",
                        "open.deadline == null ? OptionalLong.empty() : before.deadlineMillis();",
                        "before.deadlineMillis();"),
                arguments(
                        "R-RET-3",
                        "values of two visits go together",
                        "../state/Return.java",
                        "place() == other.place() && visit() != other.visit()",
                        "false"),
                arguments(
                        "R-RET-3",
                        "values of two returns of a static instance go together",
                        "../state/Return.java",
                        "? instance == other.instance :",
                        "? false :"),
                arguments(
                        "R-VAR-1",
                        "a declared variable without value is read from the parent",
                        "VariableScopes.java",
                        "if (value != null || m.plan.variables.containsKey(name)) {",
                        "if (value != null) {"),
                arguments(
                        "R-VAR-2",
                        "an undeclared variable that a child writes is the root's",
                        "VariableScopes.java",
                        "new Place(own, ownName, null)",
                        "new Place(own.root, ownName, null)"),
                arguments(
                        "R-VIS-8",
                        "nobody hears of the start marking and of other entries",
                        "Visits.java",
                        "rules.emit(new Effect.Entered(place.mission.id, place.place.id(), v.id, v.entered));",
                        ";"),
                arguments(
                        "R-VIS-8",
                        "nobody hears that nobody left",
                        "Visits.java",
                        "rules.emit(new Effect.Left(place.mission.id, place.place.id(), v.id, List.of()));",
                        ";"),
                arguments(
                        "R-VIS-8",
                        "the second token that leaves a visit is not told of",
                        "TokenRemoval.java",
                        "tokens.add(entries.get(i).token);",
                        "if (tokens.isEmpty()) { tokens.add(entries.get(i).token); }"),
                arguments(
                        "R-VIS-8",
                        "tokens are said to leave another visit of the place",
                        "TokenRemoval.java",
                        "place.place.id(), v.id, tokens",
                        "place.place.id(), v.id + 1, tokens"),
                arguments(
                        "R-VIS-8",
                        "a drop takes tokens without a word",
                        "RobotRemoval.java",
                        "rules.removal.remove(removed);",
                        "removed.forEach(e -> e.place().remove(e));"),
                arguments(
                        "R-VIS-8",
                        "a return takes tokens without a word",
                        "SharedInstances.java",
                        "rules.removal.remove(entries);",
                        "entries.forEach(e -> e.place().remove(e));"),
                arguments(
                        "R-VIS-8",
                        "a firing tells moves that it does not make",
                        "SelectedTokens.java",
                        "moves.add(new TokenMove(token, Optional.empty(), out.place().inMoves));",
                        "moves.add(new TokenMove(token, out.place().inMoves, out.place().inMoves));"),
                arguments(
                        "R-TOK-2",
                        "a root mission starts without its tasks",
                        "MissionStart.java",
                        "m.tasks.values().forEach(t -> tokens.add(new Token.Task(t.id)));",
                        ";"),
                arguments(
                        "R-VIS-3",
                        "a visit goes on without its tokens",
                        "TokenRemoval.java",
                        "if (v.hasLeft()) {",
                        "if (v.hasLeft() && v.id < 0) {"),
                arguments(
                        "R-FIRE-3",
                        "an input event writes nothing",
                        "Firing.java",
                        "rules.scopes.write(m, write.getValue(), value);",
                        ";"),
                arguments(
                        "R-TASK-3",
                        "an allocation of free tasks is not told",
                        "TaskAllocation.java",
                        "if (!tasks.isEmpty()) {",
                        "if (!before.isEmpty()) {"),
                arguments(
                        "R-TASK-5",
                        "a mapped task keeps its parent's name",
                        "ChildTokens.java",
                        "if (own.original != null && own.original.id.equals(task.task())) {",
                        "if (own.original == null && own.id.equals(task.task())) {"));
    }

    @Test
    void manyRulesAreSpoilt() {
        assertThat(rules()).hasSizeGreaterThanOrEqualTo(LEAST_SPOILT);
        assertThat(rules().map(row -> row.get()[1])).doesNotHaveDuplicates().containsAll(RARE.keySet());
    }

    @ParameterizedTest(name = "{0}: {1}")
    @MethodSource("rules")
    void disagreesSoon(String rule, String spoilt, String file, String right, String wrong, @TempDir Path folder) {
        Differential.Maker engine = SpoiltEngine.with(folder, file, right, wrong);

        Optional<Differential.Disagreement> found = Optional.empty();
        long first = RARE.getOrDefault(spoilt, 1L);
        for (long tried = 0; tried < MOST_SEEDS && found.isEmpty(); tried++) {
            found = Differential.explore(1 + (first - 1 + tried) % MOST_SEEDS, Scenario.LENGTH, engine);
        }

        assertThat(found).as("%s: %s", rule, spoilt).isPresent();
    }
}

package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.engine.MissionView;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Input;

/** Cooperative Location Visit with interrupts (thesis, Figure 7.3), on simulated boats: what pressing its buttons does. */
@Tag("long")
class InterruptedVisitsTest {
    private static final RunPlan PLAN = TestRuns.plan("clv-interrupts");
    private static final RunReport UNDISTURBED = run();

    @Test
    void withoutAPressItIsThePlanWithoutInterrupts() {
        RunPlan plain = TestRuns.plan("clv");
        RunReport clv = TestRuns.run(plain, TestRuns.settings(plain, 3, 12, 1));

        assertThat(UNDISTURBED.result().simulatedMillis())
                .isEqualTo(clv.result().simulatedMillis());
        assertThat(shares(UNDISTURBED)).isEqualTo(shares(clv));
    }

    @Test
    void rechargedBoatKeepsItsShareAndTheOthersGoOn() {
        RunReport report = run("recharge:2@60");

        assertAllVisited(report);
        assertThat(shares(report)).isEqualTo(shares(UNDISTURBED));
        assertThat(recharges(report)).containsExactly(0, 1, 0);
        assertThat(visitTimesOf("boat1", report)).isEqualTo(visitTimesOf("boat1", UNDISTURBED));
        assertThat(visitTimesOf("boat3", report)).isEqualTo(visitTimesOf("boat3", UNDISTURBED));
    }

    @Test
    void rechargedBoatDoesNotVisitAnythingTwice() {
        // the report counts a visit at 3.5 m; the boat slows down and comes to the location itself
        long afterTwo = visitTimesOf("boat2", UNDISTURBED).get(1) + 8_000;

        RunReport report = run("recharge:2@" + seconds(afterTwo));

        assertAllVisited(report);
        assertThat(visitTimesOf("boat2", report).subList(0, 2))
                .isEqualTo(visitTimesOf("boat2", UNDISTURBED).subList(0, 2));
        List<LocationResult> done = visitsOf("boat2", report).subList(0, 2);
        long back = timeOf("End recharge", report);
        BoatResult boat = report.boats().get(1);
        assertThat(done)
                .allSatisfy(location -> assertThat(boat.track().stream()
                                .filter(point -> point.atMillis() > back)
                                .filter(point -> point.speedMps() < 1)
                                .mapToDouble(point -> Math.hypot(
                                        point.eastM() - location.eastM(), point.northM() - location.northM())))
                        .allMatch(distanceM -> distanceM > 10));
    }

    @Test
    void missionWaitsForTheLastBoatToFinishWhileItRecharges() {
        LocationResult last = UNDISTURBED.locations().stream()
                .max(Comparator.comparing(l -> l.visitedAtMillis().getAsLong()))
                .orElseThrow();
        String boat = last.visitedBy();
        long others = UNDISTURBED.locations().stream()
                .filter(l -> !l.visitedBy().equals(boat))
                .mapToLong(l -> l.visitedAtMillis().getAsLong())
                .max()
                .orElseThrow();
        assertThat(others).isLessThan(last.visitedAtMillis().getAsLong() - 10_000);

        RunReport report = run("recharge:" + boat + "@" + seconds(others + 5_000));

        assertAllVisited(report);
        assertThat(report.interrupts().get(0).taken()).isTrue();
        assertThat(count("Path completed", report)).isEqualTo(3);
        assertThat(timeOf("End recharge", report)).isLessThan(report.result().simulatedMillis());
        assertThat(visitTimesOf(boat, report).get(visitTimesOf(boat, report).size() - 1))
                .isGreaterThan(timeOf("End recharge", report));
    }

    @Test
    void boatThatHadFinishedRechargesAndTheMissionWaitsForIt() {
        String first = first("Path completed", UNDISTURBED);
        long finished = timeOf("Path completed", UNDISTURBED);

        RunReport report = run("recharge:" + first + "@" + seconds(finished + 5_000));

        assertAllVisited(report);
        assertThat(count("Start recharge of a finished boat", report)).isEqualTo(1);
        assertThat(count("Start recharge", report)).isZero();
        assertThat(report.boats().stream().mapToInt(BoatResult::recharges).sum())
                .isEqualTo(1);
        assertThat(visitTimesOf(first, report)).isEqualTo(visitTimesOf(first, UNDISTURBED));
        assertThat(report.result().simulatedMillis()).isGreaterThanOrEqualTo(timeOf("End recharge", report));
    }

    @Test
    void secondBoatRechargesDuringTheFirst() {
        RunReport report = run("recharge:1@60", "recharge:3@75");

        assertAllVisited(report);
        assertThat(recharges(report)).containsExactly(1, 0, 1);
        assertThat(takenAt(report, 1)).isLessThan(timeOf("End recharge", report));
        assertThat(count("End recharge", report)).isEqualTo(2);
        assertThat(shares(report)).isEqualTo(shares(UNDISTURBED));
    }

    @Test
    void sameBoatIsTakenOnceMoreOnlyWhenItIsBack() {
        RunReport report = run("recharge:2@60", "recharge:2@70");

        assertAllVisited(report);
        InterruptResult second = report.interrupts().get(1);
        assertThat(second.presses()).isGreaterThan(1);
        assertThat(second.takenAtMillis().getAsLong()).isGreaterThanOrEqualTo(timeOf("End recharge", report));
        assertThat(count("Start recharge", report)).isEqualTo(2);
        assertThat(shares(report)).isEqualTo(shares(UNDISTURBED));
    }

    @Test
    void sameBoatRechargesTwiceWithWorkBetween() {
        RunReport report = run("recharge:2@60", "recharge:2@500");

        assertAllVisited(report);
        assertThat(recharges(report)).containsExactly(0, 2, 0);
        assertThat(report.interrupts()).allMatch(pressed -> pressed.presses() == 1);
    }

    @Test
    void alarmGathersAllAndAllGoOn() {
        RunReport report = run("alarm@100");

        assertAllVisited(report);
        assertThat(count("Start alarm", report)).isEqualTo(1);
        assertThat(count("Alarm over", report)).isEqualTo(1);
        assertThat(shares(report)).isEqualTo(shares(UNDISTURBED));
        long start = timeOf("Start alarm", report);
        long over = timeOf("Alarm over", report);
        assertThat(report.locations())
                .noneMatch(l -> l.visitedAtMillis().getAsLong() > start + 60_000
                        && l.visitedAtMillis().getAsLong() < over);
    }

    @Test
    void alarmDuringARechargeLeavesThatBoatAloneAndItWaitsForTheEnd() {
        RunReport report = run("recharge:2@60", "alarm@65");

        assertAllVisited(report);
        assertThat(recharges(report)).containsExactly(0, 1, 0);
        assertThat(move("Start alarm", report)).contains("boat1", "boat3").doesNotContain("boat2");
        assertThat(timeOf("End recharge", report)).isGreaterThanOrEqualTo(timeOf("End alarm", report));
        assertThat(shares(report)).isEqualTo(shares(UNDISTURBED));
    }

    @Test
    void buttonOfARunningSubMissionEndsTheAlarmAtOnce() {
        RunReport report = run("alarm@100", "alarm over@120");

        assertAllVisited(report);
        assertThat(timeOf("Ended by button", report)).isEqualTo(takenAt(report, 1));
        assertThat(timeOf("End alarm", report)).isEqualTo(takenAt(report, 1));
        assertThat(count("Alarm over", report)).isZero();
    }

    @Test
    void abortOfOnlyTheSubMissionReturnsItsBoatIfTheOperatorSaysYes() {
        RunReport report = runAndAbortRecharge(AnswersFile.EMPTY);

        assertAllVisited(report);
        assertThat(recharges(report)).containsExactly(0, 0, 0);
        assertThat(report.decisions()).anyMatch(decision -> decision.type().equals("aborted:recharge"));
        assertThat(shares(report)).isEqualTo(shares(UNDISTURBED));
    }

    @Test
    void abortOfOnlyTheSubMissionKeepsItsBoatIfTheOperatorSaysNo() {
        AnswersFile no =
                AnswersFileReader.read("""
                    {"format": "crw-answers", "version": 1,
                     "rules": [{"event": "aborted:recharge", "answer": {"yes": false}}]}
                    """, TestRuns.LIBRARY.vocabulary()).orThrow();

        RunReport report = runAndAbortRecharge(no);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.FAILED);
        assertThat(report.result().reason()).contains("nothing can happen");
        assertThat(visitTimesOf("boat1", report)).isEqualTo(visitTimesOf("boat1", UNDISTURBED));
        assertThat(visitTimesOf("boat2", report)).allMatch(at -> at < 61_000);
    }

    @Test
    void interruptsNest() {
        RunPlan nested = changed(PLAN, InterruptedVisitsTest::offerTheAlarmWhileRechargingToo);

        RunReport report = TestRuns.run(
                nested, TestRuns.settings(nested, 3, 12, 1).withInterrupts(List.of("recharge:2@60", "alarm@75")));

        assertAllVisited(report);
        assertThat(report.firings())
                .filteredOn(f -> f.transition().equals("Start alarm"))
                .hasSize(2);
        assertThat(report.firings())
                .filteredOn(f -> f.plan().equals("assemble") && f.transition().equals("Alarm over"))
                .extracting(FiringResult::mission)
                .doesNotHaveDuplicates()
                .hasSize(2);
        assertThat(recharges(report)).containsExactly(0, 1, 0);
        assertThat(shares(report)).isEqualTo(shares(UNDISTURBED));
    }

    @Test
    void planWithoutTheInterruptsEdgesTakesNobodyAndTheReportSaysSo() {
        RunPlan cut = changed(PLAN, project -> withoutEdges(project, "start-recharge", "start-late-recharge"));

        RunReport report = TestRuns.run(cut, TestRuns.settings(cut, 3, 12, 1).withInterrupts(List.of("recharge:2@60")));

        assertAllVisited(report);
        assertThat(recharges(report)).containsExactly(0, 0, 0);
        assertThat(visitTimesOf("boat2", report)).isEqualTo(visitTimesOf("boat2", UNDISTURBED));
        InterruptResult pressed = report.interrupts().get(0);
        assertThat(pressed.taken()).isFalse();
        assertThat(pressed.presses()).isGreaterThan(1);
    }

    @Test
    void boatThatIsNamedIsTakenWithOneWhoHasFinished() {
        String first = first("Path completed", UNDISTURBED);
        long finished = timeOf("Path completed", UNDISTURBED);

        RunReport report = run("recharge@" + seconds(finished + 5_000));

        assertAllVisited(report);
        assertThat(report.interrupts().get(0).boat().split(" ")).containsExactlyInAnyOrder("boat1", "boat2", "boat3");
        assertThat(recharges(report)).containsExactly(1, 1, 1);
        assertThat(move("Start recharge of a finished boat", report)).contains(first);
    }

    @Test
    void interruptThatFindsNobodyIsPressedUntilTheEndAndReported() {
        RunPlan noFinished = changed(PLAN, project -> withoutEdges(project, "start-late-recharge"));
        String first = first("Path completed", UNDISTURBED);
        long finished = timeOf("Path completed", UNDISTURBED);

        RunReport report = TestRuns.run(
                noFinished,
                TestRuns.settings(noFinished, 3, 12, 1)
                        .withInterrupts(List.of("recharge:" + first + "@" + seconds(finished + 1_000))));

        assertAllVisited(report);
        assertThat(report.interrupts()).singleElement().satisfies(pressed -> {
            assertThat(pressed.boat()).isEqualTo(first);
            assertThat(pressed.pressedAtMillis()).isPresent();
            assertThat(pressed.takenAtMillis()).isEmpty();
        });
    }

    private static RunReport run(String... interrupts) {
        return TestRuns.run(PLAN, TestRuns.settings(PLAN, 3, 12, 1).withInterrupts(List.of(interrupts)));
    }

    private static RunReport runAndAbortRecharge(AnswersFile answers) {
        RunSettings settings = TestRuns.settings(PLAN, 3, 12, 1).withInterrupts(List.of("recharge:2@60"));
        InProcessRun run = new InProcessRun(PLAN, settings, answers, RunJournal.none());
        run.water().clock().at(80_000, () -> {
            MissionView recharge = run.host()
                    .ask(view -> view.missions().stream()
                            .filter(mission -> mission.plan().equals("recharge"))
                            .findFirst()
                            .orElseThrow());
            run.host().post(new Input.AbortMission(recharge.id()));
        });
        return run.run(Pacer.UNPACED, RunObserver.NONE);
    }

    /** The plan after a change in its file. */
    private static RunPlan changed(RunPlan plan, java.util.function.Consumer<ObjectNode> change) {
        try {
            ObjectNode file =
                    (ObjectNode) new ObjectMapper().readTree(new ProjectWriter(plan.vocabulary()).text(plan.project()));
            file.get("plans").forEach(p -> ((ObjectNode) p).remove("testCases"));
            change.accept(file);
            Project project =
                    new ProjectReader(plan.vocabulary()).read(file.toString()).orThrow();
            return new RunPlan(
                    plan.vocabulary(), project, project.plan(plan.plan().id()).orElseThrow());
        } catch (com.fasterxml.jackson.core.JsonProcessingException e) {
            throw new AssertionError(e);
        }
    }

    private static void withoutEdges(ObjectNode project, String... transitions) {
        for (String transition : transitions) {
            for (String edges : List.of("inEdges", "outEdges")) {
                ArrayNode list = (ArrayNode) planOf(project, "clv-interrupts").get(edges);
                for (int i = list.size() - 1; i >= 0; i--) {
                    if (list.get(i).get("transition").asText().equals(transition)) {
                        list.remove(i);
                    }
                }
            }
        }
    }

    /** While boats drive to the station, the alarm is offered for them too: an interrupt within an interrupt's sub-mission. */
    private static void offerTheAlarmWhileRechargingToo(ObjectNode project) {
        ObjectNode recharge = planOf(project, "recharge");
        add(recharge, "places", """
            {"id": "assemble", "subMissions": [{"id": "run-assemble", "plan": "assemble"}]}\
            """);
        add(recharge, "transitions", """
            {"id": "start-alarm", "name": "Start alarm", "inputs":
              [{"id": "pressed", "type": "OperatorInterruptReceived", "fields": {"interruptName": "alarm"}}]}\
            """, """
            {"id": "end-alarm", "name": "End alarm"}\
            """);
        add(recharge, "inEdges", """
            {"id": "i1", "place": "go", "transition": "start-alarm",
             "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]}\
            """, """
            {"id": "i2", "place": "assemble", "transition": "end-alarm",
             "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]}\
            """);
        add(recharge, "outEdges", """
            {"id": "o1", "transition": "start-alarm", "place": "assemble",
             "requirements": [{"action": "take", "n": "all", "kind": "any-proxy"}]}\
            """, """
            {"id": "o2", "transition": "end-alarm", "place": "go",
             "requirements": [{"action": "take", "n": "all", "kind": "sub-mission-tokens"}]}\
            """);
    }

    private static ObjectNode planOf(ObjectNode project, String id) {
        for (com.fasterxml.jackson.databind.JsonNode plan : project.get("plans")) {
            if (plan.get("id").asText().equals(id)) {
                return (ObjectNode) plan;
            }
        }
        throw new AssertionError("no plan " + id);
    }

    private static void add(ObjectNode plan, String list, String... elements) {
        for (String element : elements) {
            try {
                ((ArrayNode) plan.get(list)).add(new ObjectMapper().readTree(element));
            } catch (com.fasterxml.jackson.core.JsonProcessingException e) {
                throw new AssertionError(e);
            }
        }
    }

    private static void assertAllVisited(RunReport report) {
        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).hasSize(12).allMatch(LocationResult::visited);
    }

    /** Who visited what, by the number of the location. */
    private static Map<Integer, String> shares(RunReport report) {
        Map<Integer, String> shares = new LinkedHashMap<>();
        report.locations().forEach(location -> shares.put(location.number(), location.visitedBy()));
        return shares;
    }

    private static List<LocationResult> visitsOf(String boat, RunReport report) {
        return report.locations().stream()
                .filter(location -> location.visitedBy().equals(boat))
                .sorted(Comparator.comparing(
                        location -> location.visitedAtMillis().getAsLong()))
                .toList();
    }

    private static List<Long> visitTimesOf(String boat, RunReport report) {
        return visitsOf(boat, report).stream()
                .map(location -> location.visitedAtMillis().getAsLong())
                .toList();
    }

    private static List<Integer> recharges(RunReport report) {
        return report.boats().stream().map(BoatResult::recharges).toList();
    }

    private static Optional<FiringResult> firing(String transition, RunReport report) {
        return report.firings().stream()
                .filter(firing -> firing.transition().equals(transition))
                .findFirst();
    }

    private static int count(String transition, RunReport report) {
        return (int) report.firings().stream()
                .filter(firing -> firing.transition().equals(transition))
                .count();
    }

    /** When a transition first fired. */
    private static long timeOf(String transition, RunReport report) {
        return firing(transition, report).orElseThrow().atMillis();
    }

    private static String move(String transition, RunReport report) {
        return firing(transition, report).orElseThrow().moves();
    }

    /** The boat that a transition first moved. */
    private static String first(String transition, RunReport report) {
        String moves = move(transition, report);
        return List.of("boat1", "boat2", "boat3").stream()
                .filter(moves::contains)
                .findFirst()
                .orElseThrow();
    }

    private static long takenAt(RunReport report, int press) {
        OptionalLong taken = report.interrupts().get(press).takenAtMillis();
        return taken.orElseThrow();
    }

    private static String seconds(long millis) {
        return String.format(Locale.ROOT, "%.3f", millis / 1000.0);
    }
}

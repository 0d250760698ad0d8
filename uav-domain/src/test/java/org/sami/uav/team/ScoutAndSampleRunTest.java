package org.sami.uav.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.MotionDefaults;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TaskResult;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.Pacer;
import org.sami.crw.sim.run.RunJournal;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Token;
import org.sami.spn.testcase.TestCaseRunner;
import org.sami.spn.value.GeoPoint;

/** Scout and sample on simulated boats and copters. In calm conditions positions are exact: what robots report is the simulator's truth. */
class ScoutAndSampleRunTest {
    private static final DomainLibrary TEAM =
            DomainLibrary.fromClassPath("/org/sami/domain/team").orThrow();
    private static final String PLAN = "scout-and-sample";

    private final Map<String, Set<String>> moved = new LinkedHashMap<>(); // robots by event
    private final List<GeoPoint> measuredAt = new ArrayList<>();
    private final List<List<String>> asked = new ArrayList<>(); // what stands below each question about a target

    private RunReport run(int boats, int copters, String charges, String rules) {
        String text = "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [" + rules + "]}";
        FleetSettings fleet = new FleetSettings(boats + copters, 4, 600, 1)
                .team(boats, copters)
                .with(InitialCharges.parse(charges));
        RunSettings settings = RunSettings.of(PLAN, PLAN, fleet)
                .limitMillis(7_200_000)
                .answers(text)
                .build();
        RunPlan plan = new RunPlan(
                TEAM.vocabulary(), TEAM.combined(), TEAM.combined().plan(PLAN).orElseThrow());
        AnswersFile answers = AnswersFileReader.read(text, TEAM.vocabulary()).orThrow();
        InProcessRun run = new InProcessRun(plan, settings, answers, RunJournal.none());
        run.addListener((index, atMillis, input, effects, view) -> {
            if (input instanceof Input.Received received
                    && received.occurrence().type().equals("MeasurementTaken")) {
                measuredAt.add((GeoPoint) received.occurrence().values().get("location"));
            }
            effects.stream()
                    .filter(effect -> effect instanceof Effect.DecisionOpened opened
                            && opened.decision().type().equals("ConfirmSighting"))
                    .map(effect -> ((Effect.DecisionOpened) effect).decision())
                    .forEach(decision ->
                            asked.add(DecisionPresenter.of(decision, view).description()));
            effects.stream()
                    .filter(Effect.Activated.class::isInstance)
                    .map(effect -> ((Effect.Activated) effect).activation())
                    .forEach(this::note);
        });
        return run.run(Pacer.UNPACED, RunObserver.NONE);
    }

    private void note(Activation activation) {
        Set<String> robots = moved.computeIfAbsent(activation.type(), type -> new LinkedHashSet<>());
        activation.tokens().forEach(token -> {
            if (token instanceof Token.Proxy proxy) {
                robots.add(proxy.proxy());
            } else if (token instanceof Token.Task task) {
                robots.add(activation.allocation().getOrDefault(task.task(), "nobody"));
            }
        });
    }

    private static List<String> fired(RunReport report) {
        return report.firings().stream().map(FiringResult::transition).toList();
    }

    @Test
    void coptersSearchAndBoatsMeasureWhatTheOperatorConfirms() {
        RunReport report =
                run(3, 2, "100", "{\"event\": \"ConfirmSighting\", \"nth\": 1, \"answer\": {\"yes\": false}}");

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.boats()).extracting("id").containsExactly("boat1", "boat2", "boat3", "copter1", "copter2");
        long confirmed = fired(report).stream().filter("Sample it"::equals).count();
        assertThat(fired(report)).contains("Leave it");
        assertThat(asked)
                .hasSize((int) confirmed + 1)
                .allSatisfy(lines ->
                        assertThat(lines).singleElement().asString().matches("At -?\\d+\\.\\d{5},-?\\d+\\.\\d{5}"));
        assertThat(confirmed).isGreaterThanOrEqualTo(2);
        assertThat(report.tasks())
                .hasSize((int) confirmed)
                .allMatch(task -> task.completedAtMillis().isPresent());
        assertThat(report.notes()).extracting(NoteResult::message).noneMatch(text -> text.contains("TaskStarted"));
        for (TaskResult task : report.tasks()) {
            TaskResult.Place at = task.location().orElseThrow();
            GeoPoint target = GeoPoint.of(at.latDeg(), at.lonDeg());
            assertThat(measuredAt)
                    .anyMatch(place -> Geodesy.distanceM(place, target) <= MotionDefaults.ARRIVAL_RADIUS_M);
        }
    }

    @Test
    void boatsNeverFlyAndCoptersNeverMeasure() {
        run(3, 2, "100", "");

        assertThat(moved.get("FlyPath")).containsExactlyInAnyOrder("copter1", "copter2");
        moved.forEach((event, robots) -> {
            HandlerModules.moving(event)
                    .ifPresent(kind -> assertThat(robots).as(event).allMatch(robot -> robot.startsWith(kind.word())));
            if (event.equals("TakeMeasurement")) {
                assertThat(robots).isNotEmpty().allMatch(robot -> robot.startsWith(RobotKind.BOAT.word()));
            }
        });
    }

    @Test
    void lowBatteriesBringCoptersHomeAndBoatsToASwap() {
        RunReport report = run(2, 2, "30,100,100,36", "");

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(fired(report)).contains("Copter's battery low", "Boat's battery low", "Recharged");
    }

    @Test
    void missionSaysWhatNoRobotCanDoAndEnds() {
        assertThat(run(2, 0, "100", "").notes())
                .extracting(NoteResult::message)
                .anyMatch(text -> text.equals("No robot has flight: boat1 does not fly; boat2 does not fly"));
        assertThat(run(0, 2, "100", "").notes())
                .extracting(NoteResult::message)
                .anyMatch(text -> text.contains("copter1 flies; copter2 flies"));
    }

    @Test
    void plansHaveNoFindingsAndGoAsTheirTestCasesExpect() {
        TEAM.projects().values().forEach(project -> {
            assertThat(PlanChecks.check(project, TEAM.vocabulary())).isEmpty();
            assertThat(new TestCaseRunner(project, TEAM.vocabulary()).runAll()).isEmpty();
            assertThat(project.plans())
                    .allMatch(plan -> !plan.testCases().isEmpty())
                    .allMatch(plan -> !plan.layout().isEmpty());
        });
    }
}

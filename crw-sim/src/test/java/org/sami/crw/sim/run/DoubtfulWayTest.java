package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.Asker;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.service.reach.Range;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** Before boats are sent where something is wrong the operator is asked. */
class DoubtfulWayTest {
    private static final String NEAR = "{\"boat1\": {\"lat\": 45.6975, \"lon\": 10.72}}";
    private static final String EXCHANGED = "{\"boat1\": {\"lat\": 10.72, \"lon\": 45.6975}}";
    private static final String ON_LAND = "{\"boat1\": {\"lat\": 45.7005, \"lon\": 10.72}}";
    private static final String NO_GO =
            "{\"outline\": [{\"lat\": 45.697, \"lon\": 10.719}, {\"lat\": 45.697, \"lon\": 10.721}, "
                    + "{\"lat\": 45.698, \"lon\": 10.721}, {\"lat\": 45.698, \"lon\": 10.719}]}";
    private static final String WANTED = "{\"event\": \"DoubtfulWay\", \"answer\": {\"yes\": true}}";

    private static RunReport run(String there, InitialCharges charges, String rules) {
        return ProblemRuns.run("goto", Map.of("@there", there), charges, rules);
    }

    private static List<String> asked(RunReport report) {
        return report.decisions().stream()
                .map(decision -> decision.type() + ": " + decision.prompt())
                .toList();
    }

    @Test
    void boatIsNotSentToExchangedCoordinatesUnlessTheOperatorWants() {
        RunReport report = run(EXCHANGED, InitialCharges.FULL, "");

        assertThat(asked(report))
                .singleElement()
                .asString()
                .startsWith("DoubtfulWay: boat1 is to go ")
                .endsWith("are latitude and longitude exchanged? 45.69750,10.72000 is near. Send it?");
        assertThat(report.decisions()).extracting(DecisionResult::answer).containsExactly("no");
        assertThat(report.firings()).extracting(FiringResult::transition).containsExactly("Lost");
        assertThat(report.distanceM()).isZero();
    }

    @Test
    void answersFileSendsItAllTheSame() {
        RunReport report = run(EXCHANGED, InitialCharges.FULL, WANTED);

        assertThat(report.decisions()).extracting(DecisionResult::answer).containsExactly("yes");
        assertThat(report.distanceM()).isGreaterThan(100);
    }

    @Test
    void boatIsNotSentOntoLandThatItsPlanAvoids() {
        RunReport report = run(ON_LAND, InitialCharges.FULL, "");

        assertThat(asked(report)).singleElement().asString().contains("m inside a no-go area");
        assertThat(report.distanceM()).isZero();
    }

    /** No request of the plan names the area: only the project does. */
    @Test
    void boatIsNotSentIntoANoGoAreaOfTheProjectUnasked() {
        RunReport report = ProblemRuns.runWithNoGo(NO_GO, "goto", Map.of("@there", NEAR));

        assertThat(asked(report)).singleElement().asString().matches("DoubtfulWay: .* m inside a no-go area.*");
        assertThat(report.distanceM()).isZero();
    }

    @Test
    void wayBeyondTheChargeIsAskedAboutAndDrivenWhereNobodySaysNo() {
        RunReport report = run(NEAR, InitialCharges.parse("1"), "");

        assertThat(asked(report))
                .singleElement()
                .asString()
                .matches("LongWay: boat1 is to go \\d+ m, and its charge of 1 % is sure to last for 32 m, \\d+ m less."
                        + " Send it\\?");
        assertThat(report.decisions()).extracting(DecisionResult::answer).containsExactly("yes");
        assertThat(report.distanceM()).isPositive();
    }

    @Test
    void questionIsWithdrawnWhenItsMissionIsAborted() {
        InProcessRun run = ProblemRuns.of(
                "goto",
                Map.of("@there", EXCHANGED),
                InitialCharges.FULL,
                "{\"event\": \"DoubtfulWay\", \"answer\": {\"silent\": true}}");
        run.addListener(new HostListener() {
            @Override
            public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
                if (input instanceof Input.AskOperator) {
                    run.host().post(new Input.AbortMission(1));
                }
            }
        });

        RunReport report = run.run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ABORTED);
        assertThat(report.decisions()).singleElement().satisfies(decision -> {
            assertThat(decision.closedAtMillis()).isPresent();
            assertThat(decision.answer()).isEmpty();
        });
        assertThat(report.distanceM()).isZero();
    }

    @Test
    void questionIsShownAsThatOfTheMissionAndThePlaceThatSendTheBoat() {
        InProcessRun run = ProblemRuns.of("goto", Map.of("@there", EXCHANGED), InitialCharges.FULL, "");
        List<Asker> askers = new ArrayList<>();
        run.addListener(new HostListener() {
            @Override
            public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
                for (Effect effect : effects) {
                    if (effect instanceof Effect.DecisionOpened opened) {
                        askers.add(DecisionPresenter.of(opened.decision(), view).asker());
                    }
                }
            }
        });

        run.run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(askers).singleElement().satisfies(asker -> {
            assertThat(asker.plan()).isEqualTo("goto");
            assertThat(asker.mission()).isNotBlank();
            assertThat(asker.placeName()).isNotBlank();
        });
    }

    @Test
    void ordinaryWayIsNotAskedAbout() {
        assertThat(asked(run(NEAR, InitialCharges.FULL, ""))).isEmpty();
    }

    @Test
    void simulatedBoatsGoAsFarAsTheQuestionSays() {
        assertThat(1 / HullConfig.DEFAULT.batteryPercentPerM()).isEqualTo(Range.METRES_PER_PERCENT);
    }
}

package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TrackPoint;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.Pacer;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.record.RunProgress;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;

/** A run whose plan ends as soon as its copter cannot fly on. */
class ChargeReturnsRunTest {
    /** To a place 250 m away, and then to one 2 km away, for which the charge does not last. */
    private static final String FAR = """
        {"formatVersion": 1, "id": "p", "name": "far", "domain": "uav", "plans": [{"id": "far", "name": "far", "places": [
           {"id": "choose", "name": "Choose", "start": true, "outputs": [{"id": "which", "type": "ChooseAircraft",
            "markups": [{"type": "DefaultSelection", "options": {"selection": "ALL"}}]}]},
           {"id": "near", "name": "Fly near", "outputs": [{"id": "fly-near", "type": "FlyTo",
            "fields": {"location": {"value": {"lat": 45.70225, "lon": 10.72, "alt": 30}}}}]},
           {"id": "far", "name": "Fly far", "outputs": [{"id": "fly-far", "type": "FlyTo",
            "fields": {"location": {"value": {"lat": 45.718, "lon": 10.72, "alt": 30}}}}]},
           {"id": "over", "name": "Over", "end": true}],
          "transitions": [{"id": "chosen", "inputs": [{"id": "these", "type": "AircraftChosen"}]},
           {"id": "there", "inputs": [{"id": "reached", "type": "ReachedLocation"}]},
           {"id": "cannot", "name": "It cannot", "inputs": [{"id": "cannot-fly", "type": "CannotFly"}]}],
          "inEdges": [
           {"id": "a", "place": "choose", "transition": "chosen", "requirements": [{"match": "all", "kind": "relevant"}]},
           {"id": "b", "place": "near", "transition": "there", "requirements": [{"match": "all", "kind": "relevant"}]},
           {"id": "c", "place": "far", "transition": "cannot", "requirements": [{"match": "all", "kind": "relevant"}]}],
          "outEdges": [
           {"id": "d", "transition": "chosen", "place": "near", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]},
           {"id": "e", "transition": "there", "place": "far", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]},
           {"id": "f", "transition": "cannot", "place": "over", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]}]}]}
        """;

    private static final long HOME_MS = 90_000;
    private static final long FLYING_MS = 20_000; // after its start it is in the air

    private static InProcessRun prepared() {
        Project project =
                new ProjectReader(UavRuns.DOMAIN.vocabulary()).read(FAR).orThrow();
        return UavRuns.Run.of("far", 1)
                .charged("36")
                .answering("{\"event\": \"LongWay\", \"answer\": {\"silent\": true}}")
                .prepared(project);
    }

    @Test
    void copterThatIsHeldByHandWhileNobodyAnswersComesHomeOnceItIsGivenBack() {
        InProcessRun run = prepared();
        Set<String> held = new HashSet<>();
        Consumer<RunProgress> holding = progress -> {
            if (progress.simulatedMillis() > FLYING_MS && progress.openDecisions() > 0 && held.add("copter1")) {
                run.session().byHand().hold("copter1");
            }
        };
        run.run(Pacer.UNPACED, new RunObserver(holding, () -> false));
        run.coast(HOME_MS);
        assertThat(held).isNotEmpty();
        assertThat(positions(run)).allMatch(at -> at.altM() > 10);

        run.session().byHand().giveBack("copter1");
        run.coast(HOME_MS);
        assertThat(positions(run))
                .singleElement()
                .satisfies(at -> assertThat(at.altM()).isZero());
    }

    @Test
    void copterIsDownAtHomeAfterAPlanThatEndedAsItCouldNotFly() {
        InProcessRun run = prepared();
        RunReport report = run.run(Pacer.UNPACED, RunObserver.NONE);

        TrackPoint start = report.boats().get(0).track().get(0);
        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.firings().stream().map(FiringResult::transition)).endsWith("It cannot");
        assertThat(positions(run)).allMatch(at -> at.altM() > 10);
        run.coast(HOME_MS);
        assertThat(positions(run)).singleElement().satisfies(at -> {
            assertThat(at.altM()).isZero();
            assertThat(Geodesy.distanceM(at, GeoPoint.of(start.latDeg(), start.lonDeg())))
                    .isLessThan(3);
        });
    }

    private static List<GeoPoint> positions(InProcessRun run) {
        CompletableFuture<List<GeoPoint>> answer = run.session()
                .fleet()
                .ask(boats -> boats.all().stream()
                        .flatMap(boat -> boat.status().pose().stream())
                        .map(BoatPose::position)
                        .toList())
                .toCompletableFuture();
        run.coast(1);
        return answer.join();
    }
}

package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Site;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;

/** Runs whose plans bring boats in while they run. */
class ConnectingRunTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final GeoPoint DOHA = GeoPoint.of(25.3542, 51.5283);

    private static String plan(String output) {
        return """
                {"formatVersion": 1, "id": "p", "name": "boats", "domain": "crw", "plans": [{"id": "p", "name": "boats",
                 "places": [
                  {"id": "a", "start": true, "outputs": [%s]},
                  {"id": "b", "end": true, "outputs": [{"id": "m", "type": "DisplayMessage",
                   "fields": {"message": {"value": "here"}}}]}],
                 "transitions": [{"id": "t", "inputs": [{"id": "i", "type": "ProxyCreated"}]}],
                 "inEdges": [{"id": "e1", "place": "a", "transition": "t",
                  "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]}],
                 "outEdges": [{"id": "e2", "transition": "t", "place": "b",
                  "requirements": [{"kind": "relevant", "action": "add", "n": "all"}]}]}]}
                """.formatted(output);
    }

    private static RunReport run(String text) {
        return run(text, Site.USUAL);
    }

    private static RunReport run(String text, Site site) {
        Project project = new ProjectReader(LIBRARY.vocabulary()).read(text).orThrow();
        RunSettings settings = RunSettings.of("p", "p", new FleetSettings(2, 3, 200, 5).at(site))
                .limitMillis(60_000)
                .answerAfterMillis(1000)
                .build();
        return new InProcessRun(
                        new RunPlan(
                                LIBRARY.vocabulary(), project, project.plans().get(0)),
                        settings,
                        AnswersFile.EMPTY,
                        RunJournal.none())
                .run(Pacer.UNPACED, RunObserver.NONE);
    }

    @Test
    void aBoatBehindAnAddressIsASimulatedBoatOfTheNameThatThePlanGivesIt() {
        RunReport report = run(plan("""
                {"id": "o", "type": "ConnectExistingProxy", "fields": {"name": {"value": "RED SQ"},
                 "server": {"value": "192.168.1.105:11411"}}}"""));

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.boats()).map(BoatResult::id).containsExactly("boat1", "boat2", "RED SQ");
        assertThat(report.firings().get(0).moves()).contains("RED SQ");
    }

    @Test
    void simulatedBoatsLieWhereThePlanWantsThem() {
        RunReport report = run(plan("""
                {"id": "o", "type": "CreateSimulatedProxy", "fields": {"name": {"value": "Sim"},
                 "startLocation": {"value": {"lat": 25.3542, "lon": 51.5283}}, "numberToCreate": {"value": 3}}}"""), Site.at(DOHA));

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.boats()).map(BoatResult::id).containsExactly("boat1", "boat2", "Sim1", "Sim2", "Sim3");
        assertThat(report.boats()).allSatisfy(boat -> {
            GeoPoint begin = GeoPoint.of(
                    boat.track().get(0).latDeg(), boat.track().get(0).lonDeg());
            assertThat(Geodesy.distanceM(DOHA, begin)).isLessThan(boat.id().startsWith("Sim") ? 11 : 200);
        });
    }

    @Test
    void anAddressThatIsEmptyIsAFailureThatIsReported() {
        RunReport report = run(plan("""
                {"id": "o", "type": "ConnectExistingProxy", "fields": {"name": {"value": "RED SQ"},
                 "server": {"value": " "}}}"""));

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.FAILED);
        assertThat(report.result().reason())
                .contains("nothing can happen in the mission any longer")
                .contains("there is no address to connect to");
        assertThat(report.notes())
                .filteredOn(note -> note.kind().equals("handler_failed"))
                .map(NoteResult::message)
                .anySatisfy(message -> assertThat(message).contains("there is no address to connect to"));
        assertThat(List.copyOf(report.boats())).hasSize(2);
    }
}

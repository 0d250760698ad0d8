package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;

/** A run tells where a boat was sent, and was, though its mission had promised to keep out of there; what it goes around is no alarm. */
class FenceRunTest {
    /** Goes to a point; the same plan's request for ways keeps out of a rock. */
    private static final String PLAN = """
            {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{
              "id": "p", "name": "Straight",
              "places": [{"id": "start", "start": true}, {"id": "end", "end": true},
                {"id": "drive", "outputs": [{"id": "go", "type": "ProxyGotoLatLon",
                  "fields": {"location": {"value": {"lat": %s, "lon": 10.72}}}}]},
                {"id": "ways", "outputs": [{"id": "ask", "type": "PathRequest", "fields": {"avoid": {"value": [{"outline": [
                  {"lat": 45.6998, "lon": 10.7197}, {"lat": 45.6998, "lon": 10.7203},
                  {"lat": 45.7002, "lon": 10.7203}, {"lat": 45.7002, "lon": 10.7197}]}]}}}]}],
              "transitions": [{"id": "begin"}, {"id": "over", "inputs": [{"id": "i", "type": "ProxyPathCompleted"}]}],
              "inEdges": [
                {"id": "e1", "place": "start", "transition": "begin", "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]},
                {"id": "e2", "place": "drive", "transition": "over", "requirements": [{"match": "at-least", "n": 1, "kind": "relevant"}]}],
              "outEdges": [
                {"id": "o1", "transition": "begin", "place": "drive", "requirements": [{"action": "take", "n": "all", "kind": "any-proxy"}]},
                {"id": "o2", "transition": "over", "place": "end", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]}]}]}
            """;

    @Test
    void boatThatIsSentIntoWhatItsMissionAvoidsIsToldAndReported() {
        List<String> told = new ArrayList<>();

        RunReport report = run("45.7000", told);

        assertThat(fenceNotes(report))
                .containsExactly(
                        "Mission 1, Straight sends boat1 through an area that it is to keep out of, near 45.70000,10.72000",
                        "boat1 is in an area that mission 1, Straight is to keep out of");
        assertThat(told).filteredOn(line -> line.contains("  alarm: ")).hasSize(2);
        assertThat(report.isGreen()).isTrue();
    }

    @Test
    void boatThatGoesAroundWhatItsMissionAvoidsRaisesNoAlarm() {
        List<String> told = new ArrayList<>();

        RunReport report = run("45.7010", told);

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(fenceNotes(report)).isEmpty();
        assertThat(told).noneMatch(line -> line.contains("  alarm: "));
    }

    private static RunReport run(String latDeg, List<String> told) {
        Project project = new ProjectReader(TestRuns.LIBRARY.vocabulary())
                .read(PLAN.formatted(latDeg))
                .orThrow();
        RunPlan plan = new RunPlan(
                TestRuns.LIBRARY.vocabulary(), project, project.plan("p").orElseThrow());
        return new InProcessRun(plan, TestRuns.settings(plan, 1, 1, 5), answers(), RunJournal.none())
                .run(
                        Pacer.UNPACED,
                        new RunObserver(progress -> {}, () -> false, new RunObserver.News(told::add, false)));
    }

    /** The operator lets boats go where they should not. */
    private static AnswersFile answers() {
        String text = "{\"format\": \"crw-answers\", \"version\": 1,"
                + " \"rules\": [{\"event\": \"DoubtfulWay\", \"answer\": {\"yes\": true}}]}";
        return AnswersFileReader.read(text, TestRuns.LIBRARY.vocabulary()).orThrow();
    }

    private static List<String> fenceNotes(RunReport report) {
        return report.notes().stream()
                .filter(note -> note.kind().equals(NoteResult.FENCE))
                .map(NoteResult::message)
                .toList();
    }
}

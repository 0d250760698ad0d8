package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.RunReport;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;

/** A run tells where a boat was sent, and was, though its mission had promised to keep out of there. */
class FenceRunTest {
    /** Goes straight to a point beyond the rock that the same plan's request for ways keeps out of. */
    private static final String PLAN = """
            {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{
              "id": "p", "name": "Straight",
              "places": [{"id": "start", "start": true}, {"id": "end", "end": true},
                {"id": "drive", "outputs": [{"id": "go", "type": "ProxyGotoLatLon",
                  "fields": {"location": {"value": {"lat": 45.701, "lon": 10.72}}}}]},
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
    void boatThatGoesThroughWhatItsMissionAvoidsIsToldAndReported() {
        Project project =
                new ProjectReader(TestRuns.LIBRARY.vocabulary()).read(PLAN).orThrow();
        RunPlan plan = new RunPlan(
                TestRuns.LIBRARY.vocabulary(), project, project.plan("p").orElseThrow());
        List<String> told = new ArrayList<>();

        RunReport report = new InProcessRun(
                        plan, TestRuns.settings(plan, 1, 1, 5), AnswersFile.EMPTY, RunJournal.none())
                .run(
                        Pacer.UNPACED,
                        new RunObserver(progress -> {}, () -> false, new RunObserver.News(told::add, false)));

        assertThat(report.notes())
                .filteredOn(note -> note.kind().equals(NoteResult.FENCE))
                .extracting(NoteResult::message)
                .containsExactly(
                        "Mission 1, Straight sends boat1 through an area that it is to keep out of, to 45.70100,10.72000",
                        "boat1 is in an area that mission 1, Straight is to keep out of");
        assertThat(told).filteredOn(line -> line.contains("  alarm: ")).hasSize(2);
        assertThat(report.exitCode()).isZero();
    }
}

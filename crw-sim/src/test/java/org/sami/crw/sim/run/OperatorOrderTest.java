package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.operator.decision.DecisionListener;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;

/** In which order the simulated operator answers what is asked at once (markup Priority, docs/answers-file.md). */
class OperatorOrderTest {
    /** Asks four times at once: the last is critical, two have the same rank. */
    private static final String PLAN = """
            {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{
              "id": "p", "name": "Four questions",
              "places": [{"id": "start", "start": true}, {"id": "end", "end": true}, {"id": "answered"},
                {"id": "first", "outputs": [{"id": "q1", "type": "OperatorApprove", "fields": {"question": {"value": "first"}}}]},
                {"id": "low", "outputs": [{"id": "q2", "type": "OperatorApprove", "fields": {"question": {"value": "low"}},
                  "markups": [{"type": "Priority", "options": {"rank": "LOW"}}]}]},
                {"id": "second", "outputs": [{"id": "q3", "type": "OperatorApprove", "fields": {"question": {"value": "second"}}}]},
                {"id": "now", "outputs": [{"id": "q4", "type": "OperatorApprove", "fields": {"question": {"value": "now"}},
                  "markups": [{"type": "Priority", "options": {"rank": "CRITICAL"}}]}]}],
              "transitions": [{"id": "ask"}, {"id": "over"},
                {"id": "a1", "inputs": [{"id": "i1", "type": "YesOption"}]},
                {"id": "a2", "inputs": [{"id": "i2", "type": "YesOption"}]},
                {"id": "a3", "inputs": [{"id": "i3", "type": "YesOption"}]},
                {"id": "a4", "inputs": [{"id": "i4", "type": "YesOption"}]}],
              "inEdges": [
                {"id": "e0", "place": "start", "transition": "ask", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]},
                {"id": "e1", "place": "first", "transition": "a1", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]},
                {"id": "e2", "place": "low", "transition": "a2", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]},
                {"id": "e3", "place": "second", "transition": "a3", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]},
                {"id": "e4", "place": "now", "transition": "a4", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]},
                {"id": "e5", "place": "answered", "transition": "over", "requirements": [{"match": "at-least", "n": 4, "kind": "generic"}]}],
              "outEdges": [
                {"id": "o1", "transition": "ask", "place": "first", "requirements": [{"action": "take", "n": "all", "kind": "generic"}]},
                {"id": "o2", "transition": "ask", "place": "low", "requirements": [{"action": "add", "n": 1, "kind": "generic"}]},
                {"id": "o3", "transition": "ask", "place": "second", "requirements": [{"action": "add", "n": 1, "kind": "generic"}]},
                {"id": "o4", "transition": "ask", "place": "now", "requirements": [{"action": "add", "n": 1, "kind": "generic"}]},
                {"id": "o5", "transition": "a1", "place": "answered", "requirements": [{"action": "take", "n": "all", "kind": "generic"}]},
                {"id": "o6", "transition": "a2", "place": "answered", "requirements": [{"action": "take", "n": "all", "kind": "generic"}]},
                {"id": "o7", "transition": "a3", "place": "answered", "requirements": [{"action": "take", "n": "all", "kind": "generic"}]},
                {"id": "o8", "transition": "a4", "place": "answered", "requirements": [{"action": "take", "n": "all", "kind": "generic"}]},
                {"id": "o9", "transition": "over", "place": "end", "requirements": [{"action": "take", "n": "all", "kind": "generic"}]}]}]}
            """;

    @Test
    void ofWhatIsAskedAtOnceTheMostUrgentIsAnsweredFirstThenTheOldest() {
        Project project =
                new ProjectReader(TestRuns.LIBRARY.vocabulary()).read(PLAN).orThrow();
        RunPlan plan = new RunPlan(
                TestRuns.LIBRARY.vocabulary(), project, project.plan("p").orElseThrow());
        InProcessRun run =
                new InProcessRun(plan, TestRuns.settings(plan, 1, 1, 5), AnswersFile.EMPTY, RunJournal.none());
        List<String> answered = new ArrayList<>();
        run.models().decisions().addListener(new DecisionListener() {
            @Override
            public void opened(PendingDecision decision) {}

            @Override
            public void closed(PendingDecision pending, Optional<Answer> answer, Optional<Answerer> by) {
                answered.add(pending.decision().prompt());
            }
        });

        run.run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(answered).containsExactly("now", "first", "second", "low");
    }
}

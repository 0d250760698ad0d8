package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a person follows of {@code crw run} on standard error: what the operator is asked and told, and who answers. */
class RunNewsTest {
    private static final String ASKS = """
            {"formatVersion": 1, "id": "p", "name": "Ask", "domain": "crw", "plans": [{"id": "p", "name": "Ask",
             "places": [
              {"id": "a", "start": true, "name": "Ask whether", "outputs": [
               {"id": "o", "type": "OperatorApprove", "fields": {"question": {"value": "Go on?"}}, "markups": [
                {"type": "MixedInitiativeTrigger", "options": {"trigger": "TIMER", "timeout": "PT3S"}},
                {"type": "Priority", "options": {"rank": "HIGH"}},
                {"type": "Description", "options": {"source": "It is about time"}}]}]},
              {"id": "b", "outputs": [
               {"id": "m", "type": "DisplayMessage", "fields": {"message": {"value": "going on"}}},
               {"id": "n", "type": "DisplayMessage", "fields": {"message": {"value": "going on"}}},
               {"id": "w", "type": "StartSystemTimer", "fields": {"duration": {"value": "PT5S"}}}]},
              {"id": "c", "end": true}],
             "transitions": [
              {"id": "t", "inputs": [{"id": "i", "type": "YesOption"}]},
              {"id": "f", "inputs": [{"id": "j", "type": "NoOption"}]},
              {"id": "u", "inputs": [{"id": "k", "type": "TimerExpired"}]}],
             "inEdges": [
              {"id": "e1", "place": "a", "transition": "t", "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]},
              {"id": "e2", "place": "a", "transition": "f", "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]},
              {"id": "e3", "place": "b", "transition": "u", "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]}],
             "outEdges": [
              {"id": "e4", "transition": "t", "place": "b", "requirements": [{"kind": "generic", "action": "take", "n": 1}]},
              {"id": "e5", "transition": "f", "place": "b", "requirements": [{"kind": "generic", "action": "take", "n": 1}]},
              {"id": "e6", "transition": "u", "place": "c", "requirements": [{"kind": "generic", "action": "take", "n": 1}]}]}]}
            """;

    @TempDir
    Path folder;

    private String run(String answerAfter, String... globals) throws Exception {
        Path plan = Files.writeString(folder.resolve("ask.json"), ASKS);
        List<String> words = new ArrayList<>(List.of(globals));
        words.addAll(List.of("run", plan.toString(), "--boats", "1", "--answer-after", answerAfter, "--speed", "max"));
        CommandResult ran = CommandResult.crw(words.toArray(String[]::new));
        assertThat(ran.exitCode()).as(ran.err()).isZero();
        return ran.err();
    }

    @Test
    void decisionIsToldWithAutonomysDeadlineAndThatAutonomyAnsweredIt() throws Exception {
        String told = run("30");

        assertThat(told.lines().filter(line -> line.contains("[1]")))
                .hasSize(2)
                .first()
                .asString()
                .endsWith("s  asked [1] Go on? (p), high, autonomy answers yes in 3 s");
        assertThat(told).contains("s  answered [1] by autonomy: yes");
    }

    @Test
    void whatIsDisabledForTryingIsToldBeforeTheMissionDoesIt() throws Exception {
        Path plan = Files.writeString(
                folder.resolve("disabled.json"),
                ASKS.replace("{\"id\": \"b\",", "{\"id\": \"b\", \"disabled\": true,"));

        CommandResult ran = CommandResult.crw("run", plan.toString(), "--boats", "1", "--speed", "max");

        assertThat(ran.err().lines().findFirst().orElseThrow())
                .contains("warning W-DISABLED")
                .contains("is disabled while the plan is tried");
        assertThat(ran.err()).contains("going on");
        assertThat(ran.exitCode()).as(ran.err()).isZero();
    }

    @Test
    void operatorsAnswerIsToldWithItsValue() throws Exception {
        assertThat(run("1"))
                .contains("s  answered [1] by the simulated operator: yes")
                .doesNotContain("by autonomy");
    }

    @Test
    void messageThatIsRepeatedSoonIsToldOnceAndInDetailAlways() throws Exception {
        String told = run("1");
        String detailed = run("1", "--verbose");

        assertThat(told.lines().filter(line -> line.endsWith("message: going on")))
                .hasSize(1);
        assertThat(told).doesNotContain("It is about time");
        assertThat(detailed.lines().filter(line -> line.endsWith("message: going on")))
                .hasSize(2);
        assertThat(detailed).contains("            It is about time");
    }

    @Test
    void quietRunTellsNothingOfIt() throws Exception {
        assertThat(run("1", "--quiet")).isEmpty();
    }
}

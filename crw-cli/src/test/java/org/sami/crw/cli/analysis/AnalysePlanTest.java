package org.sami.crw.cli.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;

class AnalysePlanTest {
    private static final Path PLAN = Path.of("../domain-config/src/main/resources/org/sami/domain/crw/plans/clv.json");

    @TempDir
    Path folder;

    @Test
    void planIsAskedTheUsualQuestions() {
        CommandResult ran = CommandResult.crw("analyse", "look-around", "--boats", "1");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out())
                .contains(", 1 boat: a net of ")
                .contains("it can do more than the plan, as it leaves open:")
                .contains("every state was looked at")
                .contains("each transition fires somewhere")
                .containsPattern("most boats at once: .* 1")
                .contains("deadlock: no: ")
                .contains("home ended: yes: ");
    }

    @Test
    void runOfAnAnswerNamesBoatsAndPlacesAndIsTakenOnTheEngine() throws IOException {
        String query = "invariant m(execute.robots) <= 1";

        CommandResult ran = CommandResult.crw("analyse", "clv", "--query", query);
        JsonNode json = new ObjectMapper()
                .readTree(CommandResult.crw("analyse", "clv", "--query", query, "--json")
                        .out());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out())
                .contains(query + ": no: ", "and the engine comes there by ")
                .contains("robot-1 robot-2 Choose allocation → Execute paths")
                .containsPattern("then .*Execute paths: .*robot-1 robot-2");
        assertThat(json.at("/queries/0/onEngine").asBoolean()).isTrue();
        assertThat(json.at("/queries/0/marking/execute/robot-2").asInt()).isEqualTo(1);
        assertThat(json.at("/abstractions")).isNotEmpty();
    }

    @Test
    void savedQueriesAreAnsweredWhereNoneIsGiven() throws IOException {
        ObjectNode project = (ObjectNode) new ObjectMapper().readTree(Files.readString(PLAN));
        ((ObjectNode) project.get("plans").get(0))
                .putArray("queries")
                .addObject()
                .put("name", "nobody sails")
                .put("text", "reachable m(execute.robots) >= 1")
                .put("expect", "no");
        Path file = folder.resolve("plan.json");
        Files.writeString(file, project.toString());

        CommandResult ran = CommandResult.crw("analyse", file.toString(), "--plan", "clv", "--boats", "1");

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out())
                .contains("\"nobody sails\" (reachable m(execute.robots) >= 1, expected no): yes: ")
                .doesNotContain("home ended");
    }

    @Test
    void netOfAPlanIsWrittenForOtherTools() {
        String file = folder.resolve("clv.pnml").toString();

        CommandResult written = CommandResult.crw("analyse", "clv", "--boats", "1", "--pnml", file);
        CommandResult read = CommandResult.crw("analyse", file);

        assertThat(written.out()).isEqualToIgnoringNewLines("written to " + file);
        assertThat(read.out()).contains("every reachable state was looked at");
    }

    @Test
    void searchThatIsCutSaysSo() {
        CommandResult ran = CommandResult.crw("analyse", "clv", "--boats", "3", "--budget", "20");

        assertThat(ran.exitCode()).isEqualTo(5);
        assertThat(ran.out())
                .contains("bounded search only: ", "among these states", "(home ended, expected yes): unknown: ");
    }

    @Test
    void wrongUsageIsNamed() {
        assertRefused("place with the id 'exceute'", "clv", "--query", "reachable m(exceute) > 1");
        assertRefused("--structure is for nets; --pnml FILE writes the net of a plan", "clv", "--structure");
        assertRefused("--boats is for plans; kanban-1 is a net", "kanban-1", "--boats", "1");
        assertRefused("--boats is 0 to 25, not 26", "clv", "--boats", "26");
        assertRefused("--plan: clv has no plan 'other'", "clv", "--plan", "other");
    }

    private static void assertRefused(String words, String... more) {
        String[] all = new String[more.length + 1];
        all[0] = "analyse";
        System.arraycopy(more, 0, all, 1, more.length);
        CommandResult ran = CommandResult.crw(all);
        assertThat(ran.exitCode()).as(ran.out()).isEqualTo(2);
        assertThat(ran.err()).contains(words);
    }
}

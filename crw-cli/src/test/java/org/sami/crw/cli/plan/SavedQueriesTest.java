package org.sami.crw.cli.plan;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;

class SavedQueriesTest {
    private static final Path PLAN = Path.of("../domain-config/src/main/resources/org/sami/domain/crw/plans/clv.json");

    @TempDir
    Path folder;

    /** The plan clv with queries, each a name, a text and the expected answer. */
    private String withQueries(String... queries) throws IOException {
        ObjectNode project = (ObjectNode) new ObjectMapper().readTree(Files.readString(PLAN));
        ArrayNode list = ((ObjectNode) project.get("plans").get(0)).putArray("queries");
        for (int i = 0; i < queries.length; i += 3) {
            list.addObject().put("name", queries[i]).put("text", queries[i + 1]).put("expect", queries[i + 2]);
        }
        Path file = folder.resolve("plan.json");
        Files.writeString(file, project.toString());
        return file.toString();
    }

    private static CommandResult check(String file, String... more) {
        String[] all = new String[more.length + 7];
        System.arraycopy(new String[] {"check", file, "--deep", "--states", "1", "--boats", "1"}, 0, all, 0, 7);
        System.arraycopy(more, 0, all, 7, more.length);
        return CommandResult.crw(all);
    }

    @Test
    void answersThatAreExpectedAreNoFinding() throws IOException {
        CommandResult ran = check(withQueries(
                "never stuck",
                "deadlock",
                "no",
                "can always end",
                "home ended",
                "yes",
                "one boat",
                "reachable m(execute.robots) >= 1",
                "yes"));

        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        assertThat(ran.out())
                .contains("clv: query \"never stuck\" as expected: no: ")
                .contains("clv: query \"can always end\" as expected: yes: ")
                .contains("clv: query \"one boat\" as expected: yes: such a marking is reached by ");
    }

    @Test
    void planWithoutQueriesIsAskedWhetherItAlwaysEnds() throws IOException {
        CommandResult ran = check(withQueries());

        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        assertThat(ran.out())
                .contains("clv: query \"it stops before its end\" as expected: no: ")
                .contains("clv: query \"every run can end\" as expected: yes: ");
    }

    @Test
    void otherAnswerIsAFindingWithTheRunThatShowsIt() throws IOException {
        String file = withQueries("nobody sails", "reachable m(execute.robots) >= 1", "no");

        CommandResult ran = check(file);
        JsonNode json = new ObjectMapper().readTree(check(file, "--json").out());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out())
                .contains("clv: query \"nobody sails\" NOT AS EXPECTED (no): yes: such a marking is reached by ")
                .contains("    Allocation accepted")
                .containsPattern("    then .*Execute paths: .*robot-1");
        assertThat(json.at("/queries/0/result").asText()).isEqualTo("unexpected");
        assertThat(json.at("/queries/0/run")).isNotEmpty();
        assertThat(json.at("/queries/0/marking").asText()).contains("Execute paths: ");
    }

    @Test
    void queryThatMeansNothingIsAFindingWithItsColumn() throws IOException {
        CommandResult ran = check(withQueries("misspelt", "reachable m(exceute) >= 1", "yes"));

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out()).contains("clv: query \"misspelt\" has a fault: column 13: ", "'exceute'");
    }
}

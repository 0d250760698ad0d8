package org.sami.crw.cli.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;

class AnalyseCommandTest {
    @TempDir
    Path folder;

    private String written(String net) {
        String file = folder.resolve(net + ".pnml").toString();
        CommandResult ran = CommandResult.crw("analyse", net, "--write", file);
        assertThat(ran.exitCode()).as(ran.err()).isZero();
        return file;
    }

    @Test
    void wholeGraphOfAFileIsDescribed() {
        CommandResult ran = CommandResult.crw("analyse", written("philosophers-5"));

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out().lines())
                .contains(
                        "philosophers-5 (25 places, 25 transitions)",
                        "every reachable state was looked at",
                        "2 deadlocks, the nearest after 5 firings",
                        "run: takeLeft0 takeLeft1 takeLeft2 takeLeft3 takeLeft4",
                        "each transition fires somewhere",
                        "at most 1 token in a place")
                .anyMatch(line -> line.matches(
                        "243 states, 945 edges in \\d+\\.\\d\\d s: \\d+ states a second, \\d+\\.\\d bytes a state"));
    }

    @Test
    void queriesAreAnsweredOneByOneAndAFaultIsAnExitCode() {
        CommandResult ran = CommandResult.crw(
                "analyse", "philosophers-5", "--query", "invariant m(eats0) + m(eats1) <= 1", "--query", "deadlock");

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out())
                .contains("invariant m(eats0) + m(eats1) <= 1: yes, proved by ")
                .contains("right0 + eats0 + fork1 + left1 + eats1 is always 1")
                .contains("deadlock: yes, a deadlock is reached by 5 firings");
    }

    @Test
    void queryThatFindsNoFaultEndsWell() {
        assertThat(CommandResult.crw("analyse", "kanban-1", "--query", "deadlock")
                        .exitCode())
                .isZero();
        assertThat(CommandResult.crw("analyse", "kanban-1", "--query", "reachable m(out4) = 7")
                        .exitCode())
                .isZero();
        assertThat(CommandResult.crw("analyse", "kanban-1", "--query", "home m(out4) = 7")
                        .exitCode())
                .isEqualTo(1);
    }

    @Test
    void whatTheStructureProvesIsSearchedForWhenAsked() {
        CommandResult ran = CommandResult.crw(
                "analyse", "philosophers-5", "--search", "--query", "invariant m(eats0) + m(eats1) <= 1");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .contains("yes, a marking that breaks it is never reached")
                .contains("243 states, ");
    }

    @Test
    void symmetryCountsStatesThatAreAlikeAsOne() {
        CommandResult ran = CommandResult.crw("analyse", "shared-memory-5", "--symmetry");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out()).contains("every reachable state was looked at").contains("\n51 states, ");
    }

    @Test
    void jsonHasNumbersVerdictAndWitness() throws Exception {
        CommandResult ran = CommandResult.crw(
                "analyse", written("producer-consumer-2"), "--json", "--query", "reachable m(buffer) = 2");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        JsonNode json = new ObjectMapper().readTree(ran.out());
        JsonNode query = json.get("queries").get(0);
        assertThat(query.get("verdict").asText()).isEqualTo("yes");
        assertThat(query.get("witness")).hasSize(4);
        assertThat(query.get("marking").get("buffer").asInt()).isEqualTo(2);
        assertThat(query.get("states").asInt()).isPositive();
        assertThat(query.get("bytesPerState").asDouble()).isPositive();
    }

    @Test
    void ofAMarkingWithManyPlacesTheFirstAreShownAndHowManyThereAre() throws Exception {
        CommandResult text = CommandResult.crw("analyse", "philosophers-25", "--query", "reachable m(eats0) = 1");
        CommandResult json =
                CommandResult.crw("analyse", "philosophers-25", "--json", "--query", "reachable m(eats0) = 1");

        assertThat(text.out()).containsPattern("\nmarking: (\\S+ ){20}\\.\\.\\. and 28 more\n");
        JsonNode query = new ObjectMapper().readTree(json.out()).get("queries").get(0);
        assertThat(query.get("marking")).hasSize(20);
        assertThat(query.get("markedPlaces").asInt()).isEqualTo(48);
    }

    @Test
    void searchBeyondItsBudgetSaysSoAndHasACodeOfItsOwn() throws Exception {
        CommandResult ran = CommandResult.crw("analyse", "producer-consumer-0", "--budget", "1000");
        CommandResult json = CommandResult.crw(
                "analyse", "producer-consumer-0", "--budget", "1000", "--search", "--json", "--query", "bound buffer");

        assertThat(ran.exitCode()).isEqualTo(5);
        assertThat(ran.out()).contains("bounded search only: the budget of states was used up");
        assertThat(json.exitCode()).isEqualTo(5);
        assertThat(new ObjectMapper()
                        .readTree(json.out())
                        .get("queries")
                        .get(0)
                        .get("verdict")
                        .asText())
                .isEqualTo("unknown");
    }

    @Test
    void faultsOfTheFileAreNamedWithTheirLines() throws Exception {
        Path file = Files.writeString(folder.resolve("bad.pnml"), """
            <pnml><net id="n" type="http://www.pnml.org/version-2009/grammar/ptnet">
            <place id="p"><initialMarking><text>-1</text></initialMarking></place>
            </net></pnml>
            """);

        CommandResult ran = CommandResult.crw("analyse", file.toString());
        CommandResult json = CommandResult.crw("analyse", file.toString(), "--json");

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out()).isEqualTo(file + ":2: error E-NUMBER at place p: -1 is not between 0 and 2147483647\n");
        assertThat(json.exitCode()).isEqualTo(1);
        assertThat(new ObjectMapper()
                        .readTree(json.out())
                        .get("findings")
                        .get(0)
                        .get("line")
                        .asInt())
                .isEqualTo(2);
    }

    @Test
    void whatMakesNoSenseIsRefused() {
        CommandResult query = CommandResult.crw("analyse", "kanban-1", "--query", "reachable m(nowhere) = 1");
        CommandResult net = CommandResult.crw("analyse", "kanban");
        CommandResult budget = CommandResult.crw("analyse", "kanban-1", "--budget", "0");
        CommandResult memory = CommandResult.crw("analyse", "kanban-1", "--memory", "100000000");

        assertThat(query.exitCode()).isEqualTo(2);
        assertThat(query.err())
                .contains("--query 'reachable m(nowhere) = 1', column 13: the net has no place with the id 'nowhere'");
        assertThat(net.exitCode()).isEqualTo(2);
        assertThat(net.err()).contains("there is no file 'kanban'").contains("kanban-N (N from 1 to 1000)");
        assertThat(budget.err()).contains("--budget is 1 to");
        assertThat(memory.err()).contains("--memory is 0 to").contains("JAVA_OPTS=-Xmx");
    }
}

package org.sami.crw.cli.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;

class AnalyseStructureTest {
    @TempDir
    Path folder;

    @Test
    void unboundedPlacesAreNamedWithARunThatPumpsThem() {
        CommandResult ran = CommandResult.crw("analyse", "producer-consumer-0", "--structure");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out().lines())
                .contains(
                        "P-invariants: 2",
                        "    ready + made is always 1",
                        "    make + put + take + use",
                        "no deadlock, proved by siphons and traps",
                        "    {ready, made} is a siphon and a trap, marked at first",
                        "each transition can always fire again, as the net is free-choice",
                        "minimal coverability set of 4 markings, its graph has 8 edges",
                        "    buffer is unbounded (ω): it grows with each round of make put",
                        "at most 1 tokens: ready, made, waits, taken");
    }

    @Test
    void aNetThatStructureBoundsIsNotSearched() {
        CommandResult ran = CommandResult.crw("analyse", "kanban-9", "--structure");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out())
                .contains("kanban1 + machine1 + rework1 + out1 is always 9")
                .contains("at most 9 tokens: kanban1, machine1")
                .doesNotContain("coverability");
    }

    @Test
    void aSiphonThatMayBecomeEmptyIsNamed() {
        CommandResult ran = CommandResult.crw("analyse", "philosophers-3", "--structure");

        assertThat(ran.out())
                .contains("structure does not prove that there is no deadlock")
                .containsPattern("siphon \\{.*\\} contains no marked trap: it may become empty, and stays so");
    }

    @Test
    void whatTimeDoesNotDoForIsNotDecided() {
        CommandResult ran = CommandResult.crw("analyse", "shared-memory-40", "--structure", "--time", "0.001");

        assertThat(ran.exitCode()).as(ran.err()).isEqualTo(5);
        assertThat(ran.out())
                .contains("whether there is no deadlock was not decided within 0.001 s")
                .contains("bounds not decided within 0.001 s: bus,");
    }

    @Test
    void programsReadAllOfIt() throws Exception {
        CommandResult ran = CommandResult.crw("analyse", "producer-consumer-0", "--structure", "--json");

        JsonNode object = new ObjectMapper().readTree(ran.out());
        assertThat(object.at("/placeInvariants/0/value").asInt()).isEqualTo(1);
        assertThat(object.at("/placeInvariants/0/weights/ready").asInt()).isEqualTo(1);
        assertThat(object.at("/transitionInvariants/0/put").asInt()).isEqualTo(1);
        assertThat(object.at("/allInvariants").asBoolean()).isTrue();
        assertThat(object.at("/neverStops/method").asText()).isEqualTo("siphons and traps");
        assertThat(object.at("/coverability/markings").asInt()).isEqualTo(4);
        assertThat(object.at("/coverability/unbounded/0").asText()).isEqualTo("buffer");
        assertThat(object.at("/coverability/set"))
                .hasSize(4)
                .anyMatch(marking -> marking.at("/buffer").asText().equals("ω"));
        assertThat(object.at("/coverability/edges")).hasSize(8);
        assertThat(object.at("/placeInvariantBasis")).hasSize(2);
        assertThat(object.at("/mostTokens/made").asInt()).isEqualTo(1);
        assertThat(object.at("/mostTokens").has("buffer")).isFalse();
    }

    @Test
    void whatIsUndecidableHereSaysHowFarItWasSearched() throws Exception {
        Path file = folder.resolve("counter.pnml");
        Files.writeString(file, COUNTER);

        CommandResult ran = CommandResult.crw("analyse", file.toString(), "--structure", "--budget", "40");

        assertThat(ran.exitCode()).isEqualTo(5);
        assertThat(ran.out())
                .contains("undecidable here, as inhibitor or reset arcs go to places without a proved bound (counted):"
                        + " searched to 41 markings (the budget of states was used up)")
                .contains("no bound is known: counted, zero");
    }

    @Test
    void queriesAboutANetWithoutEndAreAnswered() {
        CommandResult bounds = CommandResult.crw(
                "analyse", "producer-consumer-0", "--query", "bound buffer", "--query", "bound waits");
        CommandResult never = CommandResult.crw(
                "analyse",
                "producer-consumer-0",
                "--query",
                "reachable m(buffer) >= 5 and m(made) >= 2",
                "--query",
                "reachable m(buffer) >= 3 and m(taken) >= 1");

        assertThat(bounds.exitCode()).as(bounds.err()).isEqualTo(1);
        assertThat(bounds.out())
                .contains("bound buffer: no, place buffer is unbounded: it grows with each round of make put")
                .contains("bound waits: yes, place waits has at most 1 tokens");
        assertThat(never.exitCode()).as(never.err()).isZero();
        assertThat(never.out())
                .contains("reachable m(buffer) >= 5 and m(made) >= 2: no, proved by P-invariants")
                .contains("reachable m(buffer) >= 3 and m(taken) >= 1: yes, such a marking is reached by 9 firings");
    }

    @Test
    void queriesAreAskedWithoutStructure() {
        CommandResult ran = CommandResult.crw("analyse", "kanban-1", "--structure", "--query", "deadlock");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("--structure answers no --query");
    }

    private static final String COUNTER = """
        <pnml xmlns="http://www.pnml.org/version-2009/grammar/pnml">
          <net id="n" type="http://www.pnml.org/version-2009/grammar/ptnet">
            <page id="g">
              <place id="counted"/>
              <place id="zero"/>
              <transition id="count"/>
              <transition id="isZero"/>
              <arc id="a1" source="count" target="counted"/>
              <arc id="a2" source="isZero" target="zero"/>
              <arc id="a3" source="counted" target="isZero"><type value="inhibitor"/></arc>
            </page>
          </net>
        </pnml>
        """;
}

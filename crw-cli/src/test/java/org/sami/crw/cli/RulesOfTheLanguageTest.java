package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Plans that stand or fall with one rule of the language, run with simulated boats by the command. */
class RulesOfTheLanguageTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @Test
    void abortThatIsDrawnIntoAnEndPlaceIsAnAbort() throws Exception {
        CommandResult ran = run("abort-drawn-into-an-end");

        assertThat(ran.exitCode()).as(ran.err()).isEqualTo(3);
        assertThat(outcome(ran)).isEqualTo("aborted");
    }

    @Test
    void abortMissionOnAnEndPlaceIsAnAbort() throws Exception {
        CommandResult ran = run("abort-at-an-end");

        assertThat(ran.exitCode()).as(ran.err()).isEqualTo(3);
        assertThat(outcome(ran)).isEqualTo("aborted");
    }

    @Test
    void returnValuesWaitUntilTheGateOpens() throws Exception {
        CommandResult ran = run("return-values-wait", "--plan", "m", "--boats", "2", "--interrupt", "open@20");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(outcome(ran)).isEqualTo("ended");
    }

    @Test
    void boatThatIsPulledBeforeItsReturnIsUsedIsNotThereTwice() throws Exception {
        CommandResult ran = run(
                "pulled-before-its-return-is-used",
                "--plan",
                "m",
                "--boats",
                "2",
                "--interrupt",
                "pull:1@10",
                "--interrupt",
                "open@20");

        // The last transition wants two boats back and one away: with two boats in all it may never fire.
        assertThat(ran.exitCode()).as(ran.err()).isEqualTo(4);
        assertThat(outcome(ran)).isEqualTo("failed");
    }

    @Test
    void missionGoesOnUntilEveryBoatIsHome() throws Exception {
        CommandResult ran = run("out-and-home", "--boats", "2");

        assertThat(outcome(ran)).isEqualTo("ended");
        // From the quay to its point in the north is 210 m for the first boat, and from there home 165 m.
        assertThat(JSON.readTree(ran.out()).at("/boats/0/distanceM").asDouble()).isGreaterThan(350);
    }

    private static String outcome(CommandResult ran) throws Exception {
        return JSON.readTree(ran.out()).get("outcome").asText();
    }

    private static CommandResult run(String plan, String... options) throws URISyntaxException {
        Path file = Path.of(RulesOfTheLanguageTest.class
                .getResource("/org/sami/crw/cli/rules/" + plan + ".json")
                .toURI());
        List<String> args = new ArrayList<>(List.of("run", file.toString(), "--speed", "max", "--json"));
        args.addAll(List.of(options));
        return CommandResult.crw(args.toArray(String[]::new));
    }
}

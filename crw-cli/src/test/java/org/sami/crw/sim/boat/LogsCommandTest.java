package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;

/** {@code crw logs} against real boats on loopback. */
@Timeout(900)
class LogsCommandTest {
    @TempDir
    private Path folder;

    @Test
    void logsOfAllBoatsComeAndASecondFetchOnlyAddsWhatIsNew() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(Files.createDirectories(folder.resolve("boats")))) {
            BoatOnTcp anna = fleet.boat("anna");
            BoatOnTcp bert = fleet.boat("bert");
            CommandResult first = fetch(at(anna), at(bert));
            assertThat(first.exitCode()).as(first.out() + first.err()).isZero();
            Path annas = folder.resolve("out/anna/anna.log");
            assertThat(annas).hasSameBinaryContentAs(folder.resolve("boats/anna.log"));
            assertThat(folder.resolve("out/bert/bert.log")).hasSameBinaryContentAs(folder.resolve("boats/bert.log"));

            long before = Files.size(annas);
            CommandResult.crw("stop", at(anna));
            CommandResult second = fetch(at(anna), at(bert));

            long added = Files.size(folder.resolve("boats/anna.log")) - before;
            assertThat(second.out().lines())
                    .containsExactly(
                            at(anna) + "  anna: " + annas + ", " + added + " bytes fetched",
                            at(bert) + "  bert: " + folder.resolve("out/bert/bert.log") + ", nothing new");
            assertThat(annas).hasSameBinaryContentAs(folder.resolve("boats/anna.log"));
        }
    }

    @Test
    void boatThatIsGoneIsNamedAndTheOthersLogsCome() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(Files.createDirectories(folder.resolve("boats")))) {
            BoatOnTcp anna = fleet.boat("anna");
            BoatOnTcp gone = fleet.boat("gone");
            String nowhere = at(gone);
            gone.close();

            CommandResult ran = fetch(nowhere, at(anna));

            assertThat(ran.exitCode()).isEqualTo(4);
            assertThat(ran.out()).contains(nowhere + "  Connection refused", "anna: ");
            assertThat(folder.resolve("out/anna/anna.log")).exists();
        }
    }

    @Test
    void fileInsteadOfAFolderIsRefused() throws Exception {
        Files.writeString(folder.resolve("out"), "");

        CommandResult ran = fetch("127.0.0.1:1");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("is no folder");
    }

    private CommandResult fetch(String... addresses) {
        return CommandResult.crw(
                "logs",
                String.join(",", addresses),
                "--out",
                folder.resolve("out").toString());
    }

    private static String at(BoatOnTcp boat) {
        return "127.0.0.1:" + boat.address().getPort();
    }
}

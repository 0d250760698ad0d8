package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.cli.CrwProcess;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalReader;

/** Two bases on one journal in PostgreSQL, and boats, all of them processes: the base that runs a mission is killed in its middle, and its standby goes on with it. */
@Tag("process")
@Timeout(600)
class StandbyTakesOverTest {
    private static final List<String> BOATS = List.of("anna", "bert");
    private static final String AT = "the session is at ";

    /** A machine with much else to do starts processes slowly. */
    private static final double AT_MOST_S = 120;

    /** The second locations of both boats are some 40 m away: a minute's way, longer than a take-over. */
    private static final String MISSION = """
        wait boats 2 within 60
        start clv
        wait decision within 60
        answer all
        wait decision within 60
        answer 45.4001,10.9;45.4001,10.9001;45.4004,10.9;45.4004,10.9001
        wait decision within 60
        answer 1
        """;

    @TempDir
    private Path folder;

    @Test
    void theStandbyOfAKilledBaseEndsItsMissionAndNoBoatCarriesOutACommandTwice() throws Exception {
        try (EmbeddedPostgres database = database();
                BoatProcesses fleet = new BoatProcesses(folder).with("anna", "bert")) {
            String journal = "postgresql://localhost:" + database.getPort() + "/postgres?user=postgres";
            List<JournalEntry> before;
            try (CrwProcess first =
                            serve(journal, "--connect", fleet.addresses(), "--script", script("mission", MISSION));
                    CrwProcess standby = serve(journal, "--standby")) {
                await(standby, "standby: the session is held by ");
                for (String boat : BOATS) {
                    Await.until(boat + " is under way", AT_MOST_S, () -> isUnderWay(fleet, boat) || !first.isAlive());
                }
                assertThat(first.isAlive()).as(first.out() + first.err()).isTrue();
                before = entries(journal);

                first.kill();

                await(standby, AT);
                CommandResult front = front(standby);
                entries(journal).stream()
                        .skip(before.size() - 3)
                        .limit(14)
                        .forEach(e -> System.err.println("ENTRY " + e));
                System.err.println(standby.err());
                assertThat(front.exitCode()).as(front.out() + front.err()).isZero();
                System.err.println(front.out() + standby.out() + first.out());
            }
            assertThat(before).isNotEmpty();
            assertThat(entries(journal))
                    .as("the inputs before the kill")
                    .startsWith(before.toArray(JournalEntry[]::new));
            for (String boat : BOATS) {
                System.err.println(fleet.log(boat).stream()
                        .map(e -> e.timeMs() + " " + e.clientId() + " "
                                + e.command().getClass().getSimpleName() + " "
                                + e.command().commandId()
                                + (e.command() instanceof org.sami.boat.link.UploadWaypoints u
                                        ? " " + u.listId() + " " + u.waypoints().size()
                                        : e.command() instanceof StartWaypoints w
                                                ? " " + w.listId() + " " + w.index()
                                                : ""))
                        .toList());
                assertThat(fleet.commandIds(boat)).as(boat).isNotEmpty().doesNotHaveDuplicates();
            }
        }
    }

    private static EmbeddedPostgres database() throws IOException {
        return EmbeddedPostgres.builder()
                .setOverrideWorkingDirectory(
                        Path.of("build", "postgres").toAbsolutePath().toFile())
                .setPGStartupWait(Duration.ofMinutes(2))
                .start();
    }

    private CrwProcess serve(String journal, String... more) throws IOException {
        List<String> line = new java.util.ArrayList<>(List.of("serve", "--port", "0", "--journal", journal));
        line.addAll(List.of(more));
        return CrwProcess.start(folder, line);
    }

    private String script(String name, String lines) throws IOException {
        return Files.writeString(folder.resolve(name), lines).toString();
    }

    private static void await(CrwProcess base, String words) {
        Await.until("'" + words + "'", AT_MOST_S, () -> base.out().contains(words) || !base.isAlive());
        assertThat(base.out()).as(base.err()).contains(words);
    }

    /** What somebody sees who takes part in the session of a base until its missions are over. */
    private CommandResult front(CrwProcess base) throws IOException {
        String said = base.out();
        String url = said.substring(said.indexOf(AT) + AT.length())
                .lines()
                .findFirst()
                .orElseThrow()
                .split(",")[0];
        String lines = "missions\nboats\nwait ended within 50\nmissions\nboats\nhealth\nlog\nquit\n";
        return CommandResult.crw(
                "session",
                "--session",
                url.replace("http", "ws"),
                "--person",
                "anna",
                "--script",
                script("look", lines));
    }

    private static boolean isUnderWay(BoatProcesses fleet, String boat) {
        return fleet.log(boat).stream().anyMatch(entry -> entry.command() instanceof StartWaypoints);
    }

    private static List<JournalEntry> entries(String journal) throws IOException {
        try (JournalReader reader = JournalAddress.parse(journal).read()) {
            return reader.entries();
        }
    }
}

package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.cli.CrwProcess;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalPlans;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.work.postgres.testing.TestDatabase;

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
    void standbyOfAKilledBaseEndsItsMissionAndBoatsGoOnAlongTheirLists() throws Exception {
        String journal = TestDatabase.address().text();
        try (BoatProcesses fleet = new BoatProcesses(folder).with("anna", "bert")) {
            List<JournalEntry> before;
            try (CrwProcess first =
                            serve(journal, "--connect", fleet.addresses(), "--script", script("mission", MISSION));
                    CrwProcess standby = serve(journal, "--standby")) {
                await(standby, "standby: the session is held by ");
                await(standby, "standby: warm: applied up to entry ");
                for (String boat : BOATS) {
                    Await.until(boat + " is under way", AT_MOST_S, () -> isUnderWay(fleet, boat) || !first.isAlive());
                }
                // A list is started before the base has noted that the boat took it; one that is not noted is sent
                // anew.
                Await.until("the lists are noted", AT_MOST_S, () -> areListsNoted(journal) || !first.isAlive());
                assertThat(first.isAlive()).as(first.out() + first.err()).isTrue();
                before = entries(journal);

                first.kill();

                await(standby, AT);
                assertThat(standby.out()).contains("standby: applied up to entry " + before.size() + ", ");
                CommandResult front = front(standby);
                assertThat(front.exitCode()).as(front.out() + front.err()).isZero();
                assertThat(front.out()).contains("1  clv  ended");
            }
            assertThat(before).isNotEmpty();
            assertThat(entries(journal))
                    .as("the inputs before the kill")
                    .startsWith(before.toArray(JournalEntry[]::new));
            assertReplaysToTheEndOfTheMission(journal);
            for (String boat : BOATS) {
                assertThat(fleet.commandIds(boat)).as(boat).isNotEmpty().doesNotHaveDuplicates();
                assertGoesOnAlongItsList(fleet, boat);
            }
        }
    }

    /** An engine that steps through all entries of both bases ends where theirs did. */
    private static void assertReplaysToTheEndOfTheMission(String journal) throws IOException {
        JournalAddress address = JournalAddress.parse(journal);
        try (JournalReader reader = address.read()) {
            Engine engine = JournalPlans.engine(address, reader.header());
            EngineState state = engine.newState();
            List<Effect> effects = new ArrayList<>();
            reader.entries().forEach(entry -> effects.addAll(engine.step(state, entry.atMillis(), entry.input())));
            assertThat(effects).hasAtLeastOneElementOfType(Effect.MissionEnded.class);
            assertThat(engine.view(state).missions()).isEmpty();
            assertThat(StateCodec.encode(reader.stateAt(reader.lastIndex(), engine)))
                    .isEqualTo(StateCodec.encode(state));
        }
    }

    /** It got its list once, from the first base, and was started on that list by both. */
    private static void assertGoesOnAlongItsList(BoatProcesses fleet, String boat) {
        List<String> uploaded = new ArrayList<>();
        Set<String> started = new LinkedHashSet<>();
        Set<String> bases = new LinkedHashSet<>();
        fleet.log(boat).forEach(entry -> {
            if (entry.command() instanceof UploadWaypoints upload) {
                uploaded.add(upload.listId());
            } else if (entry.command() instanceof StartWaypoints start) {
                started.add(start.listId());
                bases.add(entry.clientId());
            }
        });
        assertThat(uploaded).as(boat).hasSize(1);
        assertThat(started).as(boat).containsExactlyElementsOf(uploaded);
        assertThat(bases).as(boat).hasSize(2);
    }

    private CrwProcess serve(String journal, String... more) throws IOException {
        List<String> line = new ArrayList<>(List.of("serve", "--port", "0", "--journal", journal));
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
        String lines = "missions\nboats\nwait ended within 300\nmissions\nboats\nhealth\nlog\nquit\n";
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

    private static boolean areListsNoted(String journal) {
        Set<String> noted = new HashSet<>();
        try {
            for (JournalEntry entry : entries(journal)) {
                if (entry.input() instanceof Input.Remember remembered) {
                    noted.add(remembered.key());
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return BOATS.stream().allMatch(boat -> noted.contains("list/" + boat));
    }

    private static List<JournalEntry> entries(String journal) throws IOException {
        try (JournalReader reader = JournalAddress.parse(journal).read()) {
            return reader.entries();
        }
    }
}

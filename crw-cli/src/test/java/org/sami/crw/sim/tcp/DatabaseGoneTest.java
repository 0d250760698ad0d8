package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.server.log.LoggedCommand;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.cli.CrwProcess;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.health.HealthKind;
import org.sami.session.client.RemoteSession;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalReader;
import org.sami.work.postgres.testing.DatabaseProcess;
import org.sami.work.postgres.testing.TestDatabase;

/** A base, boats, two fronts and the database of the journal, all of them processes: the database fails in the middle of a mission. */
@Tag("process")
@Isolated("its seconds are counted on real clocks")
@Timeout(600)
class DatabaseGoneTest {
    private static final List<String> BOATS = List.of("anna", "bert");

    /** Both boats have a way of a minute before them once it has been answered. */
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

    // Twice the 2 s in which fronts tell it, and twice the lease: a machine with much else to do is late.
    private static final long TOLD_MS = 4000;
    private static final long STILL_MS = 7000;

    @TempDir
    private Path folder;

    private DatabaseProcess database;
    private BoatProcesses fleet;
    private BaseAndStandby bases;
    private CrwProcess base;
    private CrwProcess console;
    private RemoteSession front;

    @BeforeEach
    void haveBoatsUnderWay() throws Exception {
        database = new DatabaseProcess(folder.resolve("data"));
        fleet = new BoatProcesses(folder).with("anna", "bert");
        bases = new BaseAndStandby(folder);
        base = bases.serve(database.address().text(), "--connect", fleet.addresses());
        front = bases.front();
        // Begun by the last of them: boats are not at the end of their way because a process is slow to start.
        console = bases.console(MISSION.concat("wait ended within 300\nquit").split("\n"));
        for (String boat : BOATS) {
            Await.until(boat + " is under way", BaseAndStandby.AT_MOST_S, () -> startsOf(boat) == 1 || !base.isAlive());
        }
        Await.until("the front shows that boats are under way", () -> speedMps() > 0.3);
    }

    @AfterEach
    void end() throws Exception {
        if (front != null) {
            front.close();
        }
        if (bases != null) {
            bases.close();
        }
        if (fleet != null) {
            fleet.close();
        }
        if (database != null) {
            database.close();
        }
    }

    @Test
    void databaseThatIsKilledIsToldByAllFrontsBoatsHoldTheirPlacesAndTheMissionGoesOnOnceItIsBack() throws Exception {
        List<JournalEntry> before = entries();
        long began = ProcessClock.ms();

        database.kill();

        assertStandsStill(began);
        database.startAgain();
        assertGoesOn(before);
    }

    @Test
    void databaseThatAnswersNothingIsToldByAllFrontsAndTheMissionGoesOnOnceItAnswers() throws Exception {
        List<JournalEntry> before = entries();
        long began = ProcessClock.ms();

        database.standStill(true);

        assertStandsStill(began);
        assertThat(console.out()).as("told while missions went on").contains("The journal's database is not reached: ");
        database.standStill(false);
        assertGoesOn(before);
    }

    @Test
    void missionDoesNotStandStillForADatabaseThatAnswersNothingForTwoSeconds() throws Exception {
        List<JournalEntry> before = entries();

        database.standStill(true);
        Await.holds("missions go on", 2, () -> !health().missionsStandStill());
        database.standStill(false);

        assertGoesOn(before);
        assertThat(console.out()).doesNotContain("Missions stand still");
    }

    @Test
    void boatsAreDrivenAndStoppedByHandWhileTheDatabaseIsGone() throws Exception {
        List<JournalEntry> before = entries();
        database.kill();
        assertStandsStill(ProcessClock.ms());

        CrwProcess hand = inConsole("drive anna 0.6 0 10", "back anna", "stop all");
        Await.until("anna is driven by hand", BaseAndStandby.AT_MOST_S, () -> speedMps() > 0.3);
        assertEnds(hand);
        for (String boat : BOATS) {
            assertThat(commands(boat, FleetStop.class))
                    .as("the fleet stop reaches " + boat)
                    .isPositive();
        }
        assertThat(health().missionsStandStill()).isTrue();

        assertEnds(inConsole("release all"));
        database.startAgain();
        assertGoesOn(before);
    }

    private CrwProcess inConsole(String... lines) throws Exception {
        List<String> script = new ArrayList<>(List.of("wait boats 2 within 60"));
        script.addAll(List.of(lines));
        script.add("quit");
        return bases.console(script.toArray(String[]::new));
    }

    /** A console has carried out each of its lines. */
    private static void assertEnds(CrwProcess console) throws Exception {
        assertThat(console.await(120)).as(console.out() + console.err()).isZero();
    }

    private long commands(String boat, Class<?> type) {
        return fleet.log(boat).stream()
                .filter(entry -> type.isInstance(entry.command()))
                .count();
    }

    /** All fronts say so before the lease of the base is over, by its end it commands nothing, and boats stay where they are. */
    private void assertStandsStill(long beganMs) {
        Await.until("the front tells it", () -> !health().of(HealthKind.JOURNAL).isEmpty());
        assertThat(ProcessClock.ms() - beganMs).as("told after ms").isLessThanOrEqualTo(TOLD_MS);
        Await.until("missions stand still", () -> health().missionsStandStill());
        assertThat(ProcessClock.ms() - beganMs).as("still after ms").isLessThanOrEqualTo(STILL_MS);
        Await.until("boats hold their places", () -> speedMps() < 0.1);
        BaseAndStandby.await(console, "FAULT: Missions stand still; the journal cannot be written: ");
        assertThat(console.out()).contains("the database ");
        for (String boat : BOATS) {
            Await.until(boat + " is told to hold", () -> listsOf(boat).size() > 1);
            assertThat(listsOf(boat))
                    .as("waypoints of the lists of %s: the way, and the place to hold", boat)
                    .hasSize(2)
                    .endsWith(1);
        }
    }

    private void assertGoesOn(List<JournalEntry> before) throws Exception {
        Await.until("all is well", BaseAndStandby.AT_MOST_S, () -> health().isWell());
        assertThat(console.await(400)).as(console.out() + console.err()).isZero();
        assertThat(console.out()).contains("mission 1 of clv: ended at ");
        assertThat(entries()).startsWith(before.toArray(JournalEntry[]::new)).hasSizeGreaterThan(before.size());
        assertThat(TestDatabase.number(database.address(), "SELECT count(*) FROM holders"))
                .as("bases that held the session")
                .isOne();
    }

    private Health health() {
        return front.models().health().snapshot();
    }

    private double speedMps() {
        return front.models().fleet().snapshot().stream()
                .mapToDouble(boat -> boat.speedMps().orElse(0))
                .sum();
    }

    private long startsOf(String boat) {
        return commands(boat, StartWaypoints.class);
    }

    /** How many waypoints each list has that a boat was given. */
    private List<Integer> listsOf(String boat) {
        return fleet.log(boat).stream()
                .map(LoggedCommand::command)
                .filter(UploadWaypoints.class::isInstance)
                .map(command -> ((UploadWaypoints) command).waypoints().size())
                .toList();
    }

    private List<JournalEntry> entries() throws IOException {
        try (JournalReader reader =
                JournalAddress.parse(database.address().text()).read()) {
            return reader.entries();
        }
    }
}

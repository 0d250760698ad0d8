package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.session.fault.BoatsAtFault;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** What becomes of a session and its boats when its journal cannot be written, or a part of it breaks; on boats that are reached over TCP. */
@Tag("long")
@Timeout(900)
@Execution(ExecutionMode.CONCURRENT)
class SessionFaultTest {
    private static final GeoPoint FAR = GeoPoint.of(45.41, 10.9);

    @TempDir
    private Path folder;

    private final FullJournal journal = new FullJournal();
    private TestSession world;

    @BeforeEach
    void open() {
        world = new TestSession(folder);
    }

    @AfterEach
    void close() throws Exception {
        world.close();
    }

    /** A session whose boat anna is under way for a mission. */
    private Session underWay(FaultPolicy policy) throws Exception {
        Session session = world.opened(TestSession.library("clv"), journal, policy);
        session.begin();
        TestSession.get(session.fleet().connect(TestSession.address(world.boat("anna"))));
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
        Await.until(
                "anna says where it is",
                () -> TestSession.get(session.fleet().boats()).get(0).pose().isPresent());
        TestSession.get(session.fleet().ask(boats -> {
            boats.find("anna")
                    .orElseThrow()
                    .commands()
                    .submit(FollowPath.of("far", 7, 1, List.of(FAR), Priority.MEDIUM));
            return true;
        }));
        awaitMode(session, BoatMode.PATH);
        return session;
    }

    private static void awaitMode(Session session, BoatMode mode) {
        Await.until(
                "anna is in mode " + mode,
                () -> TestSession.get(session.fleet().boats()).get(0).mode().equals(Optional.of(mode)));
    }

    private static boolean isHeld(Session session) {
        return TestSession.get(session.fleet()
                        .ask(boats ->
                                boats.find("anna").orElseThrow().commands().current()))
                .filter(KeepStation.class::isInstance)
                .isPresent();
    }

    private static boolean isUnderWay(Session session) {
        return TestSession.get(session.fleet()
                        .ask(boats ->
                                boats.find("anna").orElseThrow().commands().current()))
                .filter(FollowPath.class::isInstance)
                .isPresent();
    }

    private static Optional<HealthEntry> entry(Session session, HealthKind kind) {
        return session.models().health().snapshot().of(kind).stream().findFirst();
    }

    private static HealthEntry awaitEntry(Session session, HealthKind kind) {
        Await.until(kind + " is in the health", () -> entry(session, kind).isPresent());
        return entry(session, kind).orElseThrow();
    }

    private static void tryToStart(Session session) {
        session.host().post(new org.sami.spn.protocol.Input.StartMission("clv", "clv", Map.of()));
    }

    @Test
    void fullDiskHoldsBoatsIsSaidAndMissionsGoOnWhenThereIsRoom() throws Exception {
        Session session = underWay(FaultPolicy.ATTENDED);
        journal.fill();
        tryToStart(session);

        HealthEntry said = awaitEntry(session, HealthKind.JOURNAL);
        assertThat(said.severity()).isEqualTo(Priority.CRITICAL);
        assertThat(said.fault().text())
                .isEqualTo("Missions stand still; the journal cannot be written: the disk is full");
        assertThat(said.fault().advice())
                .isEqualTo("Make room on the journal's disk, and missions go on; boats hold their places, F12 works");
        assertThat(said.fault().details()).startsWith("Boats that were under way for missions hold their places");
        Await.until("anna is held", () -> isHeld(session));
        assertThat(TestSession.get(session.fleet().why("anna")).text())
                .containsPattern("holds? its place while the engine does not work.*following its path for mission 7");
        assertThatThrownBy(() -> TestSession.get(session.start("clv", "second", Map.of())))
                .hasMessageContaining("nothing is taken in now: the journal cannot be written: the disk is full");
        assertThat(session.faults().failure()).isEmpty();

        journal.makeRoom();
        Await.until("anna goes on", () -> isUnderWay(session));
        Await.until(
                "the fault is over", () -> entry(session, HealthKind.JOURNAL).isEmpty());
        assertThat(TestSession.missions(session)).hasSize(1);
        TestSession.get(session.start("clv", "second", Map.of()));
        assertThat(TestSession.missions(session)).hasSize(2);
    }

    @Test
    void fullDiskIsNoticedWhileNothingHappens() throws Exception {
        Session session = underWay(FaultPolicy.ATTENDED);
        journal.fill();

        awaitEntry(session, HealthKind.JOURNAL);
        Await.until("anna is held", () -> isHeld(session));
    }

    @Test
    void fleetStopWorksWhileTheEngineDoesNotAndIsNotEndedByRoom() throws Exception {
        Session session = underWay(FaultPolicy.ATTENDED);
        journal.fill();
        awaitEntry(session, HealthKind.JOURNAL);

        assertThat(TestSession.get(session.fleet().stopAll())).containsExactly("anna");
        awaitMode(session, BoatMode.FLEET_STOP);

        journal.makeRoom();
        Await.until(
                "the fault is over", () -> entry(session, HealthKind.JOURNAL).isEmpty());
        awaitMode(session, BoatMode.FLEET_STOP);
    }

    @Test
    void boatsAreStoppedWhereThatIsSet() throws Exception {
        Session session = underWay(FaultPolicy.ATTENDED);
        session.faults().setBoats(BoatsAtFault.STOP);
        assertThat(session.faults().boats()).isEqualTo(BoatsAtFault.STOP);
        journal.fill();

        assertThat(awaitEntry(session, HealthKind.JOURNAL).fault().details()).startsWith("All boats are stopped");
        awaitMode(session, BoatMode.FLEET_STOP);
    }

    @Test
    void whenPatienceIsOverTheSessionSaysThatItCannotGoOn() throws Exception {
        Session session = underWay(new FaultPolicy(BoatsAtFault.HOLD, 1000));
        List<String> broken = new CopyOnWriteArrayList<>();
        session.addListener(new SessionListener() {
            @Override
            public void onBroken(String reason) {
                broken.add(reason);
            }
        });
        journal.fill();

        HealthEntry said = awaitEntry(session, HealthKind.ENGINE);
        assertThat(said.fault().text())
                .startsWith("The engine has stopped: the journal cannot be written: the disk is full; it could not be"
                        + " written for 1 s");
        assertThat(said.fault().advice()).contains("by hand", "F12", "open it again");
        assertThat(said.fault().details()).contains("where its journal ends");
        Await.until("listeners know", () -> !broken.isEmpty());
        assertThat(broken).hasSize(1);
        assertThat(session.faults().failure()).isPresent();
        Await.until("boats are held", () -> isHeld(session));
        TestSession.get(session.byHand().hold("anna")); // boats are commanded still
        TestSession.get(session.ask(view -> view.proxies().size())); // and the engine's state is shown
    }

    @Test
    void memoryThatRunsOutOnTheEnginesThreadEndsTheSessionInWords() throws Exception {
        Session session = underWay(FaultPolicy.ATTENDED);
        session.execute(() -> {
            throw new OutOfMemoryError("Java heap space");
        });

        HealthEntry said = awaitEntry(session, HealthKind.ENGINE);
        assertThat(said.fault().text())
                .startsWith("The engine has stopped: memory ran out (Java heap space) on the thread 'engine'");
        awaitEntry(session, HealthKind.MEMORY);
        Await.until("anna is held", () -> isHeld(session));
        assertThatThrownBy(() -> TestSession.get(session.start("clv", "second", Map.of())))
                .hasMessageContaining("the session takes nothing in: memory ran out");
    }

    @Test
    void memoryThatRunsOutOnTheFleetsThreadEndsTheSessionAndLinksLiveOn() throws Exception {
        Session session = underWay(FaultPolicy.ATTENDED);
        assertThatThrownBy(() -> TestSession.get(session.fleet().ask(boats -> {
                    throw new OutOfMemoryError("Java heap space");
                })))
                .hasMessageContaining("Java heap space");

        awaitEntry(session, HealthKind.ENGINE);
        Await.until("anna is held", () -> isHeld(session));
        assertThat(TestSession.get(session.fleet().stopAll())).containsExactly("anna");
        awaitMode(session, BoatMode.FLEET_STOP);
    }

    @Test
    void overflowOfTheStackOrAnExceptionStaysWithItsPieceOfWorkAndIsSaid() throws Exception {
        Session session = underWay(FaultPolicy.ATTENDED);
        session.execute(() -> {
            throw new StackOverflowError();
        });
        session.execute(() -> {
            throw new IllegalStateException("a gap");
        });

        Await.until(
                "both are in the health",
                () -> entry(session, HealthKind.THREAD)
                        .filter(entry -> entry.fault()
                                .whole()
                                .matches(".*2 errors.*The last: java.lang.IllegalStateException: a gap.*"))
                        .isPresent());
        assertThat(session.faults().failure()).isEmpty();
        TestSession.get(session.start("clv", "goes on", Map.of()));
        assertThat(isUnderWay(session)).isTrue();
    }

    @Test
    void journalThatVanishesIsSaid() throws Exception {
        Path file = Files.createDirectory(folder.resolve("taken")).resolve("session.journal");
        Session session = world.opened(TestSession.library("clv"), file);
        session.begin();
        TestSession.get(session.start("clv", "first", Map.of()));
        Path away = Files.move(file.getParent(), folder.resolve("away"));

        HealthEntry said = awaitEntry(session, HealthKind.JOURNAL);
        assertThat(said.fault().text()).startsWith("The journal's file is gone");
        assertThat(said.fault().details()).contains("\"" + file + "\" is no longer there");
        assertThat(said.severity()).isEqualTo(Priority.CRITICAL);

        Files.move(away, file.getParent());
        Await.until(
                "the fault is over", () -> entry(session, HealthKind.JOURNAL).isEmpty());
    }
}

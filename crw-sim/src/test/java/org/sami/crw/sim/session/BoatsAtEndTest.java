package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.ProxyCommands;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.command.Stop;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.session.BoatsAtEnd;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.session.record.SessionNote;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** What boats under way do once a session was left, as they say it themselves. */
@Timeout(900)
class BoatsAtEndTest {
    @TempDir
    private Path folder;

    private TestSession world;

    @BeforeEach
    void open() {
        world = new TestSession(folder);
    }

    @AfterEach
    void close() throws Exception {
        world.close();
    }

    @ParameterizedTest
    @CsvSource({"STOP, STOPPED", "HOLD, HOLD", "GO_ON, PATH"})
    void boatsDoWhatIsChosenAsTheSessionIsLeft(BoatsAtEnd end, BoatMode wanted) throws Exception {
        AtomicInteger asked = new AtomicInteger();
        try (Session session = world.opened(TestSession.library("clv"), folder.resolve("session.journal"))) {
            session.begin();
            TestSession.get(session.fleet().connect(TestSession.address(world.boat("anna"))));
            TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
            GeoPoint far = GeoPoint.of(TestSession.PIER.latDeg() + 0.002, TestSession.PIER.lonDeg());
            Await.until("anna says where she is", () -> anna(session).pose().isPresent());
            TestSession.get(session.byHand().goTo("anna", far));
            Await.until("anna is under way", () -> anna(session).mode().equals(Optional.of(BoatMode.PATH)));

            Runnable last = () -> {
                Await.until("anna does it, before the session waits for anything else", () -> does(session, wanted));
                asked.incrementAndGet();
            };
            assertThat(session.leave(end, last)).isEmpty();

            assertThat(asked).hasValue(1);
            Await.until("anna goes on doing it", () -> does(session, wanted));
        }
    }

    /** Another front, such as a window elsewhere, may go on driving. */
    @ParameterizedTest
    @CsvSource({"STOP, STOPPED", "HOLD, HOLD"})
    void boatThatIsDrivenByHandDoesWhatIsChosenAndIsDrivenNoLonger(BoatsAtEnd end, BoatMode wanted) throws Exception {
        try (Session session = world.opened(TestSession.library("clv"), folder.resolve("session.journal"))) {
            session.begin();
            TestSession.get(session.fleet().connect(TestSession.address(world.boat("anna"))));
            TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
            Await.until("anna says where she is", () -> anna(session).pose().isPresent());
            TestSession.get(session.fleet().teleoperate("anna", 0.5, 0));
            Await.until("anna is driven", () -> does(session, BoatMode.TELEOPERATION));

            Runnable last = () -> assertThatThrownBy(
                            () -> TestSession.get(session.fleet().teleoperate("anna", 0.5, 0)))
                    .hasMessageContaining("the session ends");
            assertThat(session.leave(end, last)).isEmpty();

            Await.until("anna does it", () -> does(session, wanted));
        }
    }

    @Test
    void boatThatAMissionKeepsForItselfIsStillKeptByItWhenTheSessionIsLeft() throws Exception {
        try (Session session = world.opened(TestSession.library("clv"), folder.resolve("session.journal"))) {
            session.begin();
            TestSession.get(session.fleet().connect(TestSession.address(world.boat("anna"))));
            Await.until("anna says where she is", () -> anna(session).pose().isPresent());
            TestSession.get(session.fleet().ask(boats -> {
                ProxyCommands commands = boats.find("anna").orElseThrow().commands();
                commands.submit(new Stop("m1-block", 1, 1, Priority.MEDIUM, true));
                commands.submit(new KeepStation("m1-stay", 1, 2, TestSession.PIER, 3, Priority.MEDIUM, false));
                return null;
            }));

            assertThat(session.leave(BoatsAtEnd.STOP)).isEmpty();

            Optional<Value> kept = session.host().ask(view -> view.memory(Ids.NONE, "blocks/anna"));
            assertThat(kept).contains(new TextValue("1"));
        }
    }

    @Test
    void sessionThatWasLeftNotesNoLinkThatIsLostLater() throws Exception {
        List<String> notes = new CopyOnWriteArrayList<>();
        List<LinkState> links = new CopyOnWriteArrayList<>();
        try (Session session = world.opened(TestSession.library("clv"), folder.resolve("session.journal"))) {
            session.addListener(new SessionListener() {
                @Override
                public void onNote(SessionNote note) {
                    notes.add(note.text());
                }
            });
            session.begin();
            BoatOnTcp boat = world.boat("anna");
            TestSession.get(session.fleet().connect(TestSession.address(boat)));
            TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
            session.leave(BoatsAtEnd.STOP);
            session.subscribe(Runnable::run, event -> {
                if (event instanceof FleetEvent.LinkChanged changed) {
                    links.add(changed.status().link());
                }
            });

            boat.close();

            Await.until("the link is lost", () -> links.contains(LinkState.LOST));
            TestSession.get(session.fleet().boats()); // the fleet's thread has done all that followed
        }
        assertThat(notes).noneMatch(text -> text.contains("is lost"));
    }

    private static boolean does(Session session, BoatMode wanted) {
        return anna(session).mode().equals(Optional.of(wanted));
    }

    private static BoatStatus anna(Session session) {
        return TestSession.get(session.fleet().boats()).get(0);
    }
}

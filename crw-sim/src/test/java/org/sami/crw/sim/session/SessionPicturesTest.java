package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.file.BoatFiles;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.picture.BoatPicture;
import org.sami.crw.operator.picture.PanoramaPictures;
import org.sami.crw.replay.Replay;
import org.sami.crw.replay.ReplayedJournal;
import org.sami.crw.session.Session;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;

/** A session fetches the pictures that its boats take, keeps them, and shows them with messages and decisions. */
@Tag("long")
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class SessionPicturesTest {
    private static final String PLAN = """
        {"formatVersion": 1, "id": "look", "name": "look", "domain": "crw",
         "plans": [{"id": "look", "name": "look",
         "places": [
          {"id": "a", "start": true, "outputs": [{"id": "take", "type": "TakePanorama"}]},
          {"id": "b", "outputs": [{"id": "ask", "type": "OperatorApprove",
           "fields": {"question": {"value": "Is it a target?"}},
           "markups": [{"type": "RelevantProxy",
            "options": {"proxy": "RELEVANT_PROXIES", "showPictures": true}}]}]},
          {"id": "c", "end": true}],
         "transitions": [{"id": "t", "inputs": [{"id": "i", "type": "PanoramaTaken"}]},
          {"id": "u", "inputs": [{"id": "y", "type": "YesOption"}]}],
         "inEdges": [{"id": "e1", "place": "a", "transition": "t",
           "requirements": [{"kind": "relevant", "match": "all"}]},
          {"id": "e3", "place": "b", "transition": "u",
           "requirements": [{"kind": "relevant", "match": "all"}]}],
         "outEdges": [{"id": "e2", "transition": "t", "place": "b",
           "requirements": [{"kind": "relevant", "action": "take", "n": "all"}]},
          {"id": "e4", "transition": "u", "place": "c",
           "requirements": [{"kind": "relevant", "action": "take", "n": "all"}]}]}]}
        """;

    @TempDir
    private Path folder;

    @Test
    void picturesComeByThemselvesAndAreShownWithMessageAndQuestion() throws Exception {
        Path journal = folder.resolve("session.crw");
        try (TestSession world = new TestSession(folder.resolve("boats"))) {
            Session session = world.opened(project(), journal);
            Decision decision = asked(session, world.boat("anna"));
            Await.until("all pictures are here", () -> only(session).here() == 8);

            PanoramaPictures pictures = only(session);
            for (BoatPicture one : pictures.pictures()) {
                Path original = folder.resolve("boats/anna-pictures").resolve(one.name());
                assertThat(one.file().orElseThrow()).hasSameBinaryContentAs(original);
                assertThat(one.file().orElseThrow()).startsWith(folder.resolve("session.crw-pictures"));
            }
            assertThat(PosixFilePermissions.toString(
                            Files.getPosixFilePermissions(folder.resolve("session.crw-pictures"))))
                    .isEqualTo("rwx------");
            PendingDecision pending = session.models().decisions().snapshot().get(0);
            assertThat(shown(session, pending)).containsExactly(pictures);
            OperatorMessage message =
                    session.models().messages().snapshot().get(0).message();
            assertThat(message.text()).isEqualTo("anna took 8 pictures");
            assertThat(PanoramaPictures.shownWith(
                            session.models().pictures().snapshot(), message.map(), message.atMillis()))
                    .containsExactly(pictures);
            TestSession.get(session.answer(decision.id(), new Answer.YesNo(true), "test"));
        }
        try (TestSession world = new TestSession(folder.resolve("boats"))) {
            Session resumed = world.resumed(journal);
            resumed.begin();
            Await.until("the pictures are known again", () -> only(resumed).here() == 8);
        }
        Replay replay = new Replay(ReplayedJournal.open(journal), Runnable::run, Runnable::run);
        replay.goTo(Long.MAX_VALUE);
        assertThat(replay.models().pictures().snapshot().get(0).here()).isEqualTo(8);
        replay.goTo(0);
        assertThat(replay.models().pictures().snapshot()).isEmpty();
    }

    @Test
    void whatEarlierProcessesLeftOpenIsFetchedByTheNext() throws Exception {
        Path journal = folder.resolve("session.crw");
        try (TestSession world = new TestSession(folder.resolve("boats"))) {
            Session session = world.opened(project(), journal);
            BoatOnTcp anna = world.boat("anna");
            asked(session, anna);
            Await.until("a picture is here", () -> only(session).here() > 0);
        }
        try (TestSession world = new TestSession(folder.resolve("boats"))) {
            BoatOnTcp anna = world.boat("anna");
            Session resumed = world.resumed(journal);
            resumed.fleet().connect(TestSession.address(anna));
            resumed.begin();
            Await.until("all are here", () -> only(resumed).here() == 8);
        }
    }

    @Test
    void pictureThatIsTooLargeIsNamedWithItsBoatAndSize() throws Exception {
        try (TestSession world = new TestSession(folder.resolve("boats"));
                BoatOnTcp anna = boatWithALargePicture()) {
            Session session = world.opened(project(), folder.resolve("session.crw"));
            asked(session, anna);
            Await.until("nothing is open", () -> only(session).coming() == 0);

            Await.until(
                    "it is said",
                    () -> session.models().messages().snapshot().stream()
                            .anyMatch(one -> one.message().text().startsWith("anna: ")
                                    && one.message().text().contains("200000000 bytes")));
            assertThat(only(session).words())
                    .as(() -> String.valueOf(only(session).pictures()))
                    .isEqualTo("anna: 7 of 8 pictures, 1 will not come");
        }
    }

    /**
     * It gives other files than those that it takes: of any eight in a row one is too large, as a panorama that was begun again does not have the first eight.
     */
    private BoatOnTcp boatWithALargePicture() throws IOException {
        Path given = Files.createDirectories(folder.resolve("given"));
        for (int picture = 1; picture <= 64; picture++) {
            Path file = given.resolve(String.format("anna-%06d.jpg", picture));
            try (RandomAccessFile made = new RandomAccessFile(file.toFile(), "rw")) {
                made.setLength(picture % 8 == 0 ? 200_000_000 : picture);
            }
        }
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        return new BoatOnTcp(
                BoatSettings.of("anna", anyPort, TestSession.PIER, 1).withPicturesIn(folder.resolve("taken")),
                SteadyClock.ofThisMachine(),
                TcpServerListener.NONE,
                plain -> plain.withFiles(BoatFiles.none().with(KeptFile.PICTURE, given)));
    }

    private static Project project() {
        return TestSession.project(PLAN);
    }

    private static Decision asked(Session session, BoatOnTcp boat) {
        session.fleet().connect(TestSession.address(boat));
        session.begin();
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
        TestSession.get(session.start("look", "look", Map.of()));
        return TestSession.decision(session, "OperatorApprove");
    }

    private static PanoramaPictures only(Session session) {
        List<PanoramaPictures> all = session.models().pictures().snapshot();
        Await.until(
                "they are taken", () -> session.models().pictures().snapshot().size() == 1);
        return all.isEmpty() ? session.models().pictures().snapshot().get(0) : all.get(0);
    }

    private static List<PanoramaPictures> shown(Session session, PendingDecision pending) {
        return PanoramaPictures.shownWith(
                session.models().pictures().snapshot(), pending.presentation().map(), pending.openedAtMillis());
    }
}

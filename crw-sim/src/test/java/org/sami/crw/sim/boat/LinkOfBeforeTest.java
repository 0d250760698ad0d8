package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.Ack;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/** Peers of the release before, which name no session and no number of an appointment: each side says so in one line. */
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class LinkOfBeforeTest {
    @TempDir
    private Path logs;

    /** How boats and bases are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    private TcpTestFleet fleet;

    @BeforeEach
    void open() {
        fleet = new TcpTestFleet(logs, links());
    }

    @AfterEach
    void close() throws Exception {
        fleet.close();
    }

    @Test
    void boatOfBeforeIsLinkedAndAlarmedOnceHoweverOftenItIsConnected() throws Exception {
        LinkCodec codec = new LinkCodec();
        Base base = fleet.base("base");
        try (MalformedPeer before = new MalformedPeer(fleet.kindOfLinks().ofPeer("anna"), (connection, to) -> {
            to.write(codec.encode(0, new Welcome("anna", "boot", Role.OBSERVER, "")));
            to.write(codec.encode(1, new Welcome("anna", "boot", Role.COMMANDER, "boot.1")));
        })) {
            base.tcp.connect(before.address());

            Await.until("it is connected again", () -> before.spoken() >= 3);
            assertThat(base.alarms).singleElement().satisfies(alarm -> {
                assertThat(alarm.kind()).isEqualTo(LinkAlarm.Kind.LINK_OF_BEFORE);
                assertThat(alarm.text())
                        .startsWith("anna at ")
                        .endsWith(":" + before.address().getPort()
                                + " speaks the link of before: it obeys bases that were replaced. Bring it to this"
                                + " base's version");
            });
            assertThat(base.failures).isEmpty();
        }
    }

    @Test
    void baseOfBeforeIsToldInOneLineWhyItDoesNotCommandTheBoatOfANumberedBase() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        Base today = fleet.base("today");
        today.connect(boat.address(), "anna");
        Await.until("it commands", () -> today.ask("anna", BoatProxy::isCommanding));

        try (Socket socket =
                new Socket(boat.address().getAddress(), boat.address().getPort())) {
            socket.setSoTimeout(60_000);
            SecureLink link = fleet.kindOfLinks().ofBaseItself().connect(socket);
            FrameReader frames = new FrameReader(new BufferedInputStream(link.in()), new LinkCodec());
            say(link, 0, new Hello("anna", "yesterday", Role.COMMANDER, 1, ""));
            assertThat(welcome(frames).role()).isEqualTo(Role.OBSERVER);
            today.close();

            assertThat(answerOnceTheCommanderIsGone(link, frames))
                    .isEqualTo("this base speaks the link of before, without numbers of take-overs: today has the"
                            + " command, number 1; take the command, or bring the base to the boat's version");
        }
    }

    /** As long as the commander is linked the request is passed on to it; then the boat decides. */
    private static String answerOnceTheCommanderIsGone(SecureLink link, FrameReader frames) {
        AtomicLong sequence = new AtomicLong();
        AtomicReference<String> detail = new AtomicReference<>("");
        Await.until("the boat refuses", () -> {
            try {
                String id = "ask" + sequence.incrementAndGet();
                say(link, sequence.get(), new AskForCommand(id));
                LinkMessage answer = answer(frames, id);
                if (answer instanceof Nack nack && nack.reason() == NackReason.NOT_COMMANDER) {
                    detail.set(nack.detail());
                }
                return !detail.get().isEmpty();
            } catch (IOException | LinkException e) {
                throw new AssertionError(e);
            }
        });
        return detail.get();
    }

    private static void say(SecureLink link, long sequence, LinkMessage message) throws IOException {
        link.out().write(new LinkCodec().encode(new Frame(sequence, "", message)));
    }

    private static Welcome welcome(FrameReader frames) throws IOException, LinkException {
        while (true) {
            if (next(frames) instanceof Welcome welcome) {
                return welcome;
            }
        }
    }

    private static LinkMessage answer(FrameReader frames, String id) throws IOException, LinkException {
        while (true) {
            LinkMessage message = next(frames);
            boolean refused = message instanceof Nack nack && nack.commandId().equals(id);
            boolean done = message instanceof Ack ack && ack.commandId().equals(id);
            if (refused || done) {
                return message;
            }
        }
    }

    private static LinkMessage next(FrameReader frames) throws IOException, LinkException {
        return new LinkCodec().decode(frames.next().orElseThrow()).message();
    }
}

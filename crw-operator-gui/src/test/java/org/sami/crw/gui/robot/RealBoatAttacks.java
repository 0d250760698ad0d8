package org.sami.crw.gui.robot;

import static java.awt.event.KeyEvent.VK_F12;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.net.Socket;
import java.util.Optional;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.Welcome;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.spn.protocol.Answer;

/** What other clients do to the window's boats. */
final class RealBoatAttacks {
    private static final int WISHES = 3; // more at once are not passed on

    private RealBoatAttacks() {}

    /** Another client of a boat. */
    private static final class Client implements AutoCloseable {
        private final Socket socket;
        private final FrameReader frames;
        private long sequence;
        private String term = "";

        Client(BoatAddress boat, String name) throws IOException, LinkException {
            socket = new Socket(boat.host(), boat.port());
            frames = new FrameReader(new BufferedInputStream(socket.getInputStream()), new LinkCodec());
            say(new Hello("", name, Role.OBSERVER, 0, ""));
            await(Welcome.class);
        }

        void say(LinkMessage message) throws IOException {
            socket.getOutputStream().write(LinkCodec.STANDARD.encode(new Frame(sequence++, term, message)));
        }

        <M extends LinkMessage> M await(Class<M> type) throws IOException, LinkException {
            for (Optional<byte[]> next = frames.next(); next.isPresent(); next = frames.next()) {
                LinkMessage message = LinkCodec.STANDARD.decode(next.get()).message();
                if (type.isInstance(message)) {
                    return type.cast(message);
                }
            }
            throw new IOException("the boat has hung up");
        }

        void takeCommand() throws IOException, LinkException {
            say(new TakeCommand("take"));
            Welcome welcome = await(Welcome.class);
            while (welcome.role() != Role.COMMANDER) {
                welcome = await(Welcome.class);
            }
            term = welcome.term();
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    static void stopIdTaken(RobotWorld world) throws Exception {
        String own = world.clientId(); // as the boat tells every client that asks for the command
        try (Client other = new Client(world.fleet().addresses().get(0), own)) {
            for (int next = 1; next <= WISHES; next++) {
                other.say(new AskForCommand("fleet-stop#" + own + ".0." + next));
            }
            world.until("the wish is asked about", () -> !world.decisions().isEmpty());
            world.robot.press(VK_F12);
            world.until("all boats are stopped", world::allStopped);
            for (PendingDecision wish : world.decisions()) {
                RobotWorld.get(world.session().answer(wish.decision().id(), new Answer.YesNo(false), "robot"));
            }
        }
    }

    static void stopByAnotherBase(RobotWorld world) throws Exception {
        try (Client other = new Client(world.fleet().addresses().get(1), "committee-boat")) {
            other.takeCommand();
            other.say(new FleetStop("halt"));
            world.until("bert is stopped", () -> RobotWorld.isStopped(world.boat("bert")));
            world.warned("committee-boat");
            world.says("health-worst", "committee-boat");
            assertThat(RobotWorld.isStopped(world.boat("anna"))).isFalse();
        } finally {
            RobotWorld.get(world.session().fleet().takeCommand("bert"));
        }
    }
}

package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.function.Consumer;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.Traffic;
import org.sami.crw.proxy.gateway.GatewayLink;
import org.sami.spn.protocol.Priority;

/** What a base hears where the vehicle's end of its link cannot answer it. */
class BaseSessionTest {
    private final List<String> closed = new ArrayList<>();
    private final List<byte[]> said = new ArrayList<>();
    private final VehicleConnection connection = new VehicleConnection(
            InetSocketAddress.createUnresolved("mavlink:udp:14550", 5), new Heard(), Runnable::run);

    private final class Heard implements GatewayLink.Listener {
        @Override
        public void opened() {}

        @Override
        public void arrived(byte[] frame) {
            said.add(frame);
        }

        @Override
        public void said(Priority priority, String text) {}

        @Override
        public void closed(String why) {
            closed.add(why);
        }

        @Override
        public void found(InetSocketAddress vehicle) {}
    }

    /** An autopilot that has just started: which start it is, is not read yet. */
    private static final class Starting implements BaseSession.Boat {
        @Override
        public String name() {
            return "mav5";
        }

        @Override
        public String bootId() {
            throw new NoSuchElementException("it is not known");
        }

        @Override
        public void execute(CommandMessage command, String clientId, Consumer<LinkMessage> answer) {}

        @Override
        public void teleoperate(double thrust, double rudder) {}

        @Override
        public void near(Traffic traffic) {}

        @Override
        public void introduce() {}

        @Override
        public void left() {}
    }

    @Test
    void faultInAGreetingIsALineOfTheLogAndEndsTheConnectionWithItsReason() {
        List<LogRecord> lines = new ArrayList<>();
        Handler handler = new Handler() {
            @Override
            public void publish(LogRecord line) {
                lines.add(line);
            }

            @Override
            public void flush() {}

            @Override
            public void close() {}
        };
        Logger log = Logger.getLogger(GuardedWork.class.getName());
        log.addHandler(handler);
        try {
            connection.open(new BaseSession(new Starting(), connection, ""));
            connection.send(
                    LinkCodec.STANDARD.encode(new Frame(0, "", new Hello("", "laptop", Role.COMMANDER, 1, ""))));
        } finally {
            log.removeHandler(handler);
        }

        assertThat(closed)
                .singleElement()
                .asString()
                .startsWith("what the base said could not be taken: NoSuchElementException: it is not known, at ");
        assertThat(lines).singleElement().satisfies(line -> {
            assertThat(line.getMessage())
                    .startsWith("the base's words to mavlink:udp:14550/5 could not be taken: NoSuchElementException");
            assertThat(line.getThrown()).isNull();
        });
    }

    @Test
    void vehicleThatIsTakenAfterItsConnectionHasEndedSaysNothing() {
        BaseSession session = new BaseSession(new Starting(), connection, "");
        connection.open(session);
        connection.end("its autopilot has started again");

        session.takenBy("a pilot");

        assertThat(said).isEmpty();
        assertThat(session.takenBy()).isEqualTo("a pilot");
    }
}

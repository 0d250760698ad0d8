package org.sami.crw.session;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;

/**
 * Tells the operator of robots that the session's plans cannot command, as a boat among copters: what a robot is, its first report says. For the fleet's
 * thread.
 */
final class KindWatch {
    private final RobotKind robots;
    private final Supplier<ProxyRegistry> boats;
    private final MessageSink messages;
    private final LongSupplier nowMillis;
    private final Set<String> told = new HashSet<>();

    /**
     * A watch that knows no robot.
     *
     * @param robots what the session's plans command
     */
    KindWatch(RobotKind robots, Supplier<ProxyRegistry> boats, MessageSink messages, LongSupplier nowMillis) {
        this.robots = robots;
        this.boats = boats;
        this.messages = messages;
        this.nowMillis = nowMillis;
    }

    /** A robot becomes known: it says from now on when plans cannot command it. */
    void found(BoatProxy boat) {
        boat.servesPlansOf(robots);
    }

    /** Something happened to the fleet. */
    void take(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported
                && reported.status().pose().isPresent()) {
            Optional<String> why = boats.get().find(event.boat()).flatMap(BoatProxy::unfit);
            if (why.isEmpty()) {
                told.remove(event.boat()); // another one may come with its name
            } else if (told.add(event.boat())) {
                tell(event.boat(), why.get());
            }
        } else if (event instanceof FleetEvent.Removed) {
            told.remove(event.boat());
        }
    }

    private void tell(String boat, String why) {
        messages.tell(new OperatorMessage(
                nowMillis.getAsLong(),
                Ids.NONE,
                OperatorMessage.Source.DOMAIN,
                Priority.HIGH,
                boat + " " + why + ": no mission can command it",
                List.of(boat),
                ""));
    }
}

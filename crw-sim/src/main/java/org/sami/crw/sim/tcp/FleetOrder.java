package org.sami.crw.sim.tcp;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.UUID;
import java.util.function.Consumer;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.crw.session.SessionDefaults;

/**
 * Tells the boats at some addresses one thing, outside of any run: the fleet stop, its release, or nothing, to see how they are. Each
 * address has a base of its own, so that two boats of one name both get the command. A boat that another base commands is taken over.
 */
public final class FleetOrder {
    private static final long POLL_MS = 20;

    /** The command. */
    public enum Kind {
        /** Motors to zero, latched. */
        STOP,
        /** The end of a fleet stop; the boat lies still until a base commands it. */
        RELEASE,
        /** Nothing: the boat is only looked at, and nobody loses its command. */
        LOOK
    }

    /**
     * What came of it at one address.
     *
     * @param boat the boat that answered; empty if none did
     * @param done whether it has obeyed
     * @param stopped whether a fleet stop holds it now, as far as it has reported
     * @param words the same for a person, in one line
     */
    public record Answer(BoatAddress address, String boat, boolean done, boolean stopped, String words) {}

    private final Kind kind;
    private final BoatAddress address;
    private final TcpBase base;
    private boolean takenOver; // this and the next: for the base's thread alone
    private boolean told;

    private FleetOrder(Kind kind, BoatAddress address) {
        this.kind = kind;
        this.address = address;
        String client = "crw-" + kind.name().toLowerCase(Locale.ROOT) + "-" + UUID.randomUUID();
        ProxyConfig proxy = ProxyConfig.DEFAULT.withClientId(client).withTelemetryHz(SessionDefaults.TELEMETRY_HZ);
        base = new TcpBase(TcpBaseConfig.of(proxy, 1), SteadyClock.ofThisMachine(), new Finder());
        base.connect(address.toSocketAddress());
    }

    /** Takes every boat that answers; this class sends the command itself. */
    private final class Finder implements BaseListener {
        @Override
        public Consumer<FleetEvent> found(String boatId) {
            return event -> {};
        }

        @Override
        public void onBoat(BoatProxy boat) {
            if (kind != Kind.RELEASE) { // a stop needs no command
                boat.handOver().observe();
            }
        }
    }

    /**
     * Tells all at once and waits for what they answer.
     *
     * @param withinMs how long a boat may take
     * @return the answers, in the order of the addresses
     * @throws InterruptedException if it is to end; boats may have the command already
     */
    public static List<Answer> give(Kind kind, List<BoatAddress> addresses, long withinMs) throws InterruptedException {
        List<FleetOrder> orders =
                addresses.stream().map(address -> new FleetOrder(kind, address)).toList();
        try {
            long end = System.nanoTime() + withinMs * 1_000_000;
            List<Answer> answers = look(orders);
            while (!answers.stream().allMatch(Answer::done) && System.nanoTime() < end) {
                Thread.sleep(POLL_MS);
                answers = look(orders);
            }
            return answers;
        } finally {
            orders.forEach(order -> order.base.close());
        }
    }

    private static List<Answer> look(List<FleetOrder> orders) {
        List<Answer> answers = new ArrayList<>();
        orders.forEach(order -> answers.add(order.look()));
        return answers;
    }

    private Answer look() {
        Optional<Answer> answer = base.query(
                        boats -> boats.all().stream().findFirst().map(this::goOn))
                .join();
        return answer.orElseGet(() -> new Answer(address, "", false, false, "no answer" + lastEvent()));
    }

    private String lastEvent() {
        LinkReport link = base.links().join().get(0);
        if (link.connected()) {
            return "; something listens there, and says nothing that a boat would say";
        }
        return link.lastEvent().isEmpty() ? "" : ": " + link.lastEvent();
    }

    /** Does what is to be done next with the boat, and says how it stands. */
    private Answer goOn(BoatProxy boat) {
        if (boat.status().link() != LinkState.LINKED) {
            return answer(boat, false, "no answer: " + boat.explain().text());
        } else if (kind == Kind.LOOK) {
            boolean known = boat.status().mode().isPresent();
            return answer(boat, known, isStopped(boat) ? "stopped, and the stop is latched" : "not stopped");
        } else if (!boat.isCommanding() && !(kind == Kind.STOP && boat.isStoppedByAnyone())) {
            if (!takenOver) {
                takenOver = true;
                boat.handOver().takeCommand();
            }
            return answer(boat, false, "it has not handed over its command");
        } else if (!told) {
            told = true;
            tell(boat);
        }
        if (boat.isAwaitingFleetAnswer()) {
            return answer(boat, false, "it has not acknowledged");
        }
        if (kind == Kind.RELEASE && isStopped(boat)) { // the release may have been dropped
            return answer(boat, false, "it still says that it is stopped");
        }
        String word = kind == Kind.STOP
                ? "stopped, and the stop is latched"
                : "released; it moves when it is commanded again";
        return answer(boat, true, word + (takenOver ? "; taken over from another base, which only watches now" : ""));
    }

    private void tell(BoatProxy boat) {
        if (kind == Kind.STOP) {
            boat.fleetStop();
        } else {
            boat.fleetRelease();
        }
    }

    private static boolean isStopped(BoatProxy boat) {
        return boat.status().mode().filter(BoatMode.FLEET_STOP::equals).isPresent();
    }

    private Answer answer(BoatProxy boat, boolean done, String words) {
        return new Answer(address, boat.boatId(), done, isStopped(boat), words);
    }
}

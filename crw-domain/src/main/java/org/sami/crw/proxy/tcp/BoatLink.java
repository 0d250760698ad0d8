package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.RateLimit;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.Fingerprint;
import org.sami.crw.proxy.BoatProxy;

/**
 * The link to one address: it keeps a connection, asks the boat there for its name, and then carries the frames of that boat's proxy. For the base's
 * thread.
 *
 * <p>A connection without a frame for the time after which a link counts as lost is closed and not waited for: its frames would be late, and a new
 * connection may get through.
 */
final class BoatLink implements FrameSink {
    private static final LinkCodec CODEC = new LinkCodec();

    /** What a link needs of its base. */
    interface Base {
        /** A connection of this link that is not begun yet; it tells what happens on the base's thread. */
        BoatConnection connection(BoatLink link);

        /** A boat has given its name: whether this link carries it. Asked again while the answer is to wait. */
        Claim claimed(BoatLink link, Found found);

        /** Another boat answers at the address of the one that this link carries: the link carries none now. */
        void leftBy(BoatLink link, String boatId);

        /** What answers speaks another version of the link. */
        void speaksVersion(BoatLink link, int version);
    }

    /**
     * A boat that answers at the address.
     *
     * @param sinceMs when it answered first on this connection
     */
    record Found(Welcome welcome, long sinceMs) {}

    /** What a base says to a link that has found a boat. */
    enum Claim {
        /** The link carries the boat's proxy from now on; it has been given it. */
        CARRIES,
        /** Another link carried the boat, and whether it still does will be seen soon. */
        WAITS,
        /** Another link carries the boat. */
        REFUSED,
        /** So many boats have answered at this address that no further name is taken. */
        TOO_MANY
    }

    private static final int MOST_NEW_BOATS =
            8; // a phone is put into another hull, an address is given to another phone
    private static final double NEW_BOATS_A_SECOND = 1 / 600.0;

    private final InetSocketAddress address;
    private final TcpBaseConfig config;
    private final Base base;
    private final Backoff backoff;
    private final RateLimit newBoats = new RateLimit(NEW_BOATS_A_SECOND, MOST_NEW_BOATS);
    private long refusedBoats;
    private Optional<BoatProxy> proxy = Optional.empty();
    private Optional<BoatConnection> connection = Optional.empty();
    private Optional<Found> found = Optional.empty();
    private boolean open;
    private boolean understood; // something that came over the connection
    private boolean refused;
    private String refusal = "";
    private long lastHeardMs;
    private long nextTryMs = Long.MIN_VALUE;
    private long connections;
    private List<Fingerprint> withdrawnTold = List.of(); // on this connection
    private long triedAtMs;
    private long failedTries;
    private long failingSinceMs;
    private String lastEvent = "";
    private boolean lastRefused;

    BoatLink(InetSocketAddress address, TcpBaseConfig config, Base base, long seed) {
        this.address = address;
        this.config = config;
        this.base = base;
        backoff = new Backoff(config.firstRetryMs(), config.longestRetryMs(), seed);
    }

    InetSocketAddress address() {
        return address;
    }

    Optional<BoatConnection> connection() {
        return connection;
    }

    /** Whether a connection stands. */
    boolean isOpen() {
        return open;
    }

    /** When a frame came last, in ms of the base's clock. */
    long lastHeardMs() {
        return lastHeardMs;
    }

    /** Whether a boat is taken here that no address had before: not, where boats come under ever new names. What is not taken is counted. */
    boolean takesNewBoat(long nowMs) {
        boolean taken = newBoats.take(nowMs);
        refusedBoats += taken ? 0 : 1;
        return taken;
    }

    /** How many boats were not taken because they came under ever new names. */
    long refusedBoats() {
        return refusedBoats;
    }

    /** From now on it carries the frames of that proxy, which says hello over it. */
    void carry(BoatProxy carried, long nowMs) {
        proxy = Optional.of(carried);
        found = Optional.empty();
        carried.opened(nowMs);
    }

    /** Carries the boat no longer; what answers here is asked again who it is. */
    void release(String why, long nowMs) {
        Optional<BoatProxy> released = proxy;
        proxy = Optional.empty();
        connection.ifPresent(standing -> standing.close(why));
        released.ifPresent(known -> known.closed(nowMs));
    }

    /** The boat that it carries. */
    Optional<String> boatId() {
        return proxy.map(BoatProxy::boatId);
    }

    LinkReport report(long nowMs) {
        return new LinkReport(
                address,
                boatId(),
                open,
                connections,
                lastEvent,
                lastRefused,
                failedTries,
                failedTries == 0 ? 0 : nowMs - failingSinceMs,
                connection.map(BoatConnection::linkStatuses).orElse(List.of()));
    }

    /** Puts a frame of the proxy on its way; it is lost if there is no connection. */
    @Override
    public void send(byte[] frame) {
        if (open) {
            connection.orElseThrow().send(frame);
        }
    }

    /** Lets time pass: connects when it is time, gives up what has gone silent. */
    void tick(long nowMs) {
        if (proxy.isPresent() && proxy.get().isDisconnected()) {
            connection.ifPresent(standing -> standing.close("the link is cut on purpose"));
        } else if (connection.isEmpty() && nowMs >= nextTryMs) {
            BoatConnection next = base.connection(this);
            connection = Optional.of(next);
            triedAtMs = nowMs;
            next.start();
        } else if (open
                && connection
                        .flatMap(BoatConnection::peer)
                        .filter(this::isWithdrawn)
                        .isPresent()) {
            connection.orElseThrow().close("the boat's key was withdrawn at this base");
        } else if (open && nowMs - lastHeardMs > config.proxy().lostAfterMs()) {
            connection.orElseThrow().close(silence());
        }
        found.ifPresent(this::claim);
        connection.ifPresent(standing -> {
            long leftOut = standing.takeLeftOut();
            proxy.ifPresent(known -> known.leftOutUnread(leftOut));
        });
        proxy.ifPresent(known -> known.tick(nowMs));
    }

    /** On each connection, and when one more was withdrawn: a boat that was out of reach then learns it now. */
    private void carryWithdrawnKeys(BoatProxy known) {
        List<Fingerprint> withdrawn = config.security().withdrawn();
        if (!withdrawn.equals(withdrawnTold)) {
            withdrawnTold = withdrawn;
            known.withdrawKeys(withdrawn);
        }
    }

    private boolean isWithdrawn(Fingerprint boat) {
        return config.security().withdrawn().contains(boat);
    }

    private String silence() {
        return proxy.isPresent() || understood
                ? "nothing has come for " + config.proxy().lostAfterMs() + " ms"
                : "something listens there, and says nothing that a boat would say";
    }

    void opened(BoatConnection from, long nowMs) {
        if (!isPresent(from)) {
            return;
        }
        open = true;
        understood = false;
        withdrawnTold = List.of();
        connections++;
        lastHeardMs = nowMs;
        lastEvent = "connected";
        lastRefused = false;
        if (proxy.isPresent()) {
            proxy.get().opened(nowMs);
        } else {
            send(CODEC.encode(0, new Hello("", config.proxy().clientId(), Role.OBSERVER, 0, "")));
        }
    }

    void arrived(BoatConnection from, byte[] frame, long nowMs) {
        if (!isPresent(from)) {
            return; // late, out of a connection that was given up
        }
        if (refused) {
            return; // it is being closed
        }
        int version = LinkCodec.versionOf(frame);
        if (!understood && version != LinkCodec.VERSION) {
            base.speaksVersion(this, version);
            refuse("it speaks link version " + version + ", this base version " + LinkCodec.VERSION);
        } else if (proxy.isPresent()) {
            carried(proxy.get(), frame, nowMs);
        } else if (found.isEmpty()) {
            identify(frame, nowMs);
        } else {
            lastHeardMs = nowMs;
        }
    }

    /** What cannot be read does not keep the link alive. */
    private void carried(BoatProxy carried, byte[] frame, long nowMs) {
        if (carried.receive(frame, nowMs)) {
            understood = true;
            lastHeardMs = nowMs;
            backoff.reset();
            failedTries = 0;
            Optional.of(carried).filter(BoatProxy::isCommanding).ifPresent(this::carryWithdrawnKeys);
        }
        carried.otherBoat().ifPresent(other -> base.leftBy(this, carried.boatId()));
    }

    private void identify(byte[] frame, long nowMs) {
        try {
            LinkMessage message = CODEC.decode(frame).message();
            understood = true;
            lastHeardMs = nowMs;
            if (message instanceof Goodbye goodbye) {
                refuse("the boat turns this base away: " + goodbye.reason());
            } else if (message instanceof Welcome welcome) {
                found = Optional.of(new Found(welcome, nowMs));
                claim(found.get());
            }
        } catch (LinkException e) {
            boolean damaged = e.fault() == LinkException.Fault.CHECK;
            connection
                    .orElseThrow()
                    .close(damaged ? "the answer came damaged" : "what answers there is no boat: " + e.getMessage());
        }
    }

    /** Closes the connection and is in no hurry to try again. */
    private void refuse(String why) {
        refused = true;
        refusal = why;
        found = Optional.empty();
        connection.orElseThrow().close(why);
    }

    private void claim(Found claimed) {
        Claim claim = base.claimed(this, claimed);
        if (claim == Claim.REFUSED) {
            refuse("refused: " + claimed.welcome().boatId() + " is reached by another link");
        } else if (claim == Claim.TOO_MANY) {
            refuse("refused: boats answer there under ever new names, now as "
                    + claimed.welcome().boatId());
        }
    }

    void closed(BoatConnection from, String why, long nowMs) {
        if (!isPresent(from)) {
            return;
        }
        connection = Optional.empty();
        found = Optional.empty();
        open = false;
        if (failedTries++ == 0) {
            failingSinceMs = triedAtMs;
        }
        nextTryMs = nowMs + (refused ? backoff.longest() : backoff.next());
        lastEvent = refused ? refusal : why; // the boat may have hung up before
        lastRefused = refused;
        refused = false;
        proxy.ifPresent(known -> known.closed(nowMs));
    }

    /** What a gateway has found there was refused; it is tried again as soon as one that did not answer, as it may be set or exchanged at any time. */
    void refused(BoatConnection from, String why, long nowMs) {
        boolean isNow = isPresent(from);
        closed(from, why, nowMs);
        lastRefused |= isNow;
    }

    private boolean isPresent(BoatConnection from) {
        return connection.isPresent() && connection.get() == from;
    }
}

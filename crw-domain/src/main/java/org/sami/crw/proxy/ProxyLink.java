package org.sami.crw.proxy;

import java.util.Optional;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;

/** The base's end of one link: says hello until it is welcome, keeps it alive, notices when it is lost. */
final class ProxyLink {
    private static final long HELLO_MS = 1000;
    private static final long HEARTBEAT_MS = 1000;

    private final String boatId;
    private final FrameSink toBoat;
    private final ProxyConfig config;
    private LinkState state = LinkState.CONNECTING;
    private Role role = Role.OBSERVER;
    private Role wanted = Role.COMMANDER;
    private String bootId = "";
    private String term = "";
    private boolean takesTraffic;
    private long sequence;
    private long nextHelloMs = Long.MIN_VALUE;
    private long lastSentMs;
    private long lastReceivedMs;
    private long unreadable;

    ProxyLink(String boatId, FrameSink toBoat, ProxyConfig config) {
        this.boatId = boatId;
        this.toBoat = toBoat;
        this.config = config;
    }

    LinkState state() {
        return state;
    }

    /** Whether the boat takes commands from here. */
    boolean isCommanding() {
        return state == LinkState.LINKED && role == Role.COMMANDER;
    }

    /** Whether the boat takes commands from here, and is one that gives way to others. */
    boolean takesTraffic() {
        return isCommanding() && takesTraffic;
    }

    String bootId() {
        return bootId;
    }

    long unreadable() {
        return unreadable;
    }

    long lastReceivedMs() {
        return lastReceivedMs;
    }

    void send(LinkMessage message, long nowMs) {
        lastSentMs = nowMs;
        toBoat.send(new Frame(sequence++, term, message));
    }

    /** A frame has come, which keeps the link alive. */
    void received(long nowMs) {
        lastReceivedMs = nowMs;
    }

    /** Reads a frame; what cannot be read is counted. */
    Optional<Frame> read(byte[] bytes) {
        try {
            return Optional.of(LinkCodec.STANDARD.decode(bytes));
        } catch (LinkException e) {
            unreadable++;
            return Optional.empty();
        }
    }

    void hello(long nowMs) {
        nextHelloMs = nowMs + HELLO_MS;
        send(new Hello(boatId, config.clientId(), wanted, config.telemetryHz(), ""), nowMs);
    }

    /** Wishes no longer to command. */
    void observe() {
        wanted = Role.OBSERVER;
    }

    void helloIfDue(long nowMs) {
        if (nowMs >= nextHelloMs) {
            hello(nowMs);
        }
    }

    /** Takes what the boat grants. A base that loses the command while it is linked does not ask for it again by itself. */
    void welcomed(Welcome welcome) {
        if (isCommanding() || welcome.role() == Role.COMMANDER) {
            wanted = welcome.role();
        }
        state = LinkState.LINKED;
        role = welcome.role();
        bootId = welcome.bootId();
        term = welcome.term();
        takesTraffic = welcome.takesTraffic();
    }

    /** The link has closed under us. Returns whether that is news. */
    boolean closed() {
        boolean news = state == LinkState.LINKED;
        if (news) {
            state = LinkState.LOST;
        }
        return news;
    }

    /** Keeps the link alive. Returns whether it was lost just now. */
    boolean tick(long nowMs) {
        boolean lost = state == LinkState.LINKED && nowMs - lastReceivedMs > config.lostAfterMs() && closed();
        if (state != LinkState.LINKED || role != wanted) {
            helloIfDue(nowMs);
        } else if (nowMs - lastSentMs >= HEARTBEAT_MS) {
            send(new Heartbeat(Math.max(0, nowMs)), nowMs);
        }
        return lost;
    }
}

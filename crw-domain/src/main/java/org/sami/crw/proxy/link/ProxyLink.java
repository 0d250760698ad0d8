package org.sami.crw.proxy.link;

import java.util.Optional;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.Welcome;
import org.sami.crw.proxy.status.LinkState;

/** The base's end of one link: says hello until it is welcome, keeps it alive, notices when it is lost. */
public final class ProxyLink {
    private static final long HELLO_MS = 1000;
    private static final long HEARTBEAT_MS = LinkDefaults.HEARTBEAT_MS;

    private final String boatId;
    private final FrameSink toBoat;
    private final ProxyConfig config;
    private LinkState state = LinkState.CONNECTING;
    private Role role = Role.OBSERVER;
    private Role wanted = Role.COMMANDER;
    private String bootId = "";
    private String term = "";
    private final Claim claim = new Claim();
    private boolean replaced;
    private boolean takesTraffic;
    private long sequence;
    private long nextHelloMs = Long.MIN_VALUE;
    private long lastSentMs;
    private long lastReceivedMs;
    private long unreadable;

    /** A link over which nothing has come yet. */
    public ProxyLink(String boatId, FrameSink toBoat, ProxyConfig config) {
        this.boatId = boatId;
        this.toBoat = toBoat;
        this.config = config;
    }

    /** Whether the boat answers. */
    public LinkState state() {
        return state;
    }

    /** Whether the boat takes commands from here. */
    public boolean isCommanding() {
        return state == LinkState.LINKED && role == Role.COMMANDER;
    }

    /** Whether the boat takes commands from here, and is one that gives way to others. */
    public boolean takesTraffic() {
        return isCommanding() && takesTraffic;
    }

    /** Names the start of the boat's server that answered last; empty text before it ever did. */
    public String bootId() {
        return bootId;
    }

    /** The term in which the boat takes commands from here, as its newest welcome names it; empty text before the first. */
    public String term() {
        return term;
    }

    /** How many frames could not be read. */
    public long unreadable() {
        return unreadable;
    }

    /** When something came last. */
    public long lastReceivedMs() {
        return lastReceivedMs;
    }

    /** Sends a message. */
    public void send(LinkMessage message, long nowMs) {
        lastSentMs = nowMs;
        toBoat.send(new Frame(sequence++, term, message));
    }

    /** A frame has come, which keeps the link alive. */
    public void received(long nowMs) {
        lastReceivedMs = nowMs;
    }

    /** Reads a frame; what cannot be read is counted. */
    public Optional<Frame> read(byte[] bytes) {
        try {
            return Optional.of(LinkCodec.STANDARD.decode(bytes));
        } catch (LinkException e) {
            unreadable++;
            return Optional.empty();
        }
    }

    /** Says hello now. */
    public void hello(long nowMs) {
        nextHelloMs = nowMs + HELLO_MS;
        String session = config.session();
        send(new Hello(boatId, config.clientId(), wanted, config.telemetryHz(), "", session, claim.number()), nowMs);
    }

    /** Wishes no longer to command. */
    public void observe() {
        wanted = Role.OBSERVER;
    }

    /** Says hello again, if that is some time ago. */
    public void helloIfDue(long nowMs) {
        if (nowMs >= nextHelloMs) {
            hello(nowMs);
        }
    }

    /** A request for the command from whoever has it, with this base's number. */
    public AskForCommand askForCommand(String commandId) {
        return new AskForCommand(commandId, config.session(), claim.number());
    }

    /** A take-over of the command, with a number above all others. */
    public TakeCommand takeCommand(String commandId) {
        return new TakeCommand(commandId, config.session(), claim.takeOver());
    }

    /**
     * The boat does not grant the command for the number of the last hello. A base that has never commanded it did not know the number, and asks again.
     *
     * @return whether this base was replaced, and does not ask again by itself
     */
    public boolean superseded(long nowMs) {
        if (claim.isNew()) {
            hello(nowMs);
            return false;
        }
        wanted = Role.OBSERVER;
        replaced = true;
        return true;
    }

    /** By whom this base was replaced, as the boat said when it was asked for the command; empty otherwise. */
    public Optional<CommandEpoch> replacedBy() {
        return replaced ? claim.supersededBy() : Optional.empty();
    }

    /** Who was given the command last, as the boat names them: a client, or who took a vehicle without one; empty while that is this base, or where it does not say it. */
    public Optional<String> holder() {
        return isCommanding() ? Optional.empty() : claim.holder();
    }

    /** Who has taken a vehicle and is no base: a pilot, another ground station or its own failsafe, as it names them; empty while this base commands it. */
    public Optional<String> controller() {
        return isCommanding() ? Optional.empty() : claim.controller();
    }

    /** Whether the boat refuses bases that were replaced, and obeys stops of all; boats of the link of before do not. */
    public boolean isNumbered() {
        return claim.isNumbered();
    }

    /** Takes what the boat grants. A base that loses the command while it is linked does not ask for it again by itself. */
    public void welcomed(Welcome welcome) {
        if (isCommanding() || welcome.role() == Role.COMMANDER) {
            wanted = welcome.role();
        }
        claim.welcomed(welcome);
        replaced &= welcome.role() != Role.COMMANDER;
        state = LinkState.LINKED;
        role = welcome.role();
        bootId = welcome.bootId();
        term = welcome.term();
        takesTraffic = welcome.takesTraffic();
    }

    /** The link has closed under us. Returns whether that is news. */
    public boolean closed() {
        boolean news = state == LinkState.LINKED;
        if (news) {
            state = LinkState.LOST;
        }
        return news;
    }

    /** Keeps the link alive. Returns whether it was lost just now. */
    public boolean tick(long nowMs) {
        boolean lost = state == LinkState.LINKED && nowMs - lastReceivedMs > config.lostAfterMs() && closed();
        if (state != LinkState.LINKED || role != wanted) {
            helloIfDue(nowMs);
        } else if (nowMs - lastSentMs >= HEARTBEAT_MS) {
            send(new Heartbeat(Math.max(0, nowMs)), nowMs);
        }
        return lost;
    }
}

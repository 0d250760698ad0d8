package org.sami.boat.server;

import java.util.Optional;
import org.sami.boat.link.EarlierVersion;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.RateLimit;
import org.sami.boat.link.Role;

/**
 * The boat's side of one client's link. Its host hands it what arrives and says when the link has closed; both on the
 * thread that ticks the server.
 */
public final class ServerSession {
    private static final long TICK_MS = 100;
    private static final long HEARTBEAT_MS = 1000 - TICK_MS; // so that it comes once a second at least

    private final BoatServer server;
    private final FrameSink toClient;
    private Optional<Role> role = Optional.empty();
    private String clientId = "";
    private long sequence;
    private long lastReceivedMs;
    private long lastSentMs;
    private long telemetryPeriodMs;
    private long nextTelemetryMs;
    private String term = "";
    private long newestExecuted = -1; // by its sequence; it outlives every hello
    private long refusedFrames;
    private boolean wishesToCommand;
    private final RateLimit wishes = TransferLimits.wishesOfOne();
    private Optional<String> dismissal = Optional.empty();
    private boolean open = true;

    ServerSession(BoatServer server, FrameSink toClient) {
        this.server = server;
        this.toClient = toClient;
    }

    /** Takes one whole frame from the client. What cannot be read is counted and, where it names a command, refused. */
    public void receive(byte[] frame, long nowMs) {
        if (takesNothing()) {
            return;
        }
        try {
            receive(LinkCodec.STANDARD.decode(frame), nowMs);
        } catch (LinkException e) {
            refusedFrames++;
            if (e.fault() == LinkException.Fault.VERSION && !role.isPresent()) {
                refuseVersion(LinkCodec.versionOf(frame), nowMs);
                return;
            }
            send(new Nack(e.commandId(), NackReason.MALFORMED, shortened(e.getMessage())), nowMs);
        }
    }

    /** Takes a frame from a client whose link carries no bytes. */
    public void receive(Frame frame, long nowMs) {
        if (!takesNothing()) {
            server.received(this, frame, nowMs);
            lastReceivedMs = nowMs;
        }
    }

    /** Whether the boat takes nothing more from this client. */
    private boolean takesNothing() {
        return !open || dismissal.isPresent();
    }

    /** Said in the client's own frames, which it can read, and in those of this version, of which it can tell the version. */
    private void refuseVersion(int version, long nowMs) {
        String both = "link version " + version + ", this boat version " + LinkCodec.VERSION;
        String reason = "the base speaks " + both + ": bring both to the same version";
        toClient.send(EarlierVersion.goodbye(version, server.boatId(), reason));
        dismiss(reason, "it speaks " + both, nowMs);
    }

    /** The boat wants no more of this client: tells it so, and the host why it is to be dropped once that has left. */
    private void dismiss(String reason, String why, long nowMs) {
        send(new Goodbye(server.boatId(), reason), nowMs);
        dismissal = Optional.of(why);
    }

    /** Tells the client that it is turned away, for a reason in words; its host then drops it. */
    public void turnAway(String reason, long nowMs) {
        dismiss(reason, reason, nowMs);
    }

    /** Why the client is to be dropped, once what it was sent has left; empty if it is not. */
    public Optional<String> dismissal() {
        return dismissal;
    }

    /** The link has closed. If this was the commander's, the boat does at once what is set for a lost link. */
    public void closed(long nowMs) {
        if (open) {
            open = false;
            server.closed(this, nowMs);
        }
    }

    /** What the client is, or empty before its hello. */
    public Optional<Role> role() {
        return role;
    }

    /** How many frames of this client could not be read. */
    public long refusedFrames() {
        return refusedFrames;
    }

    /** The name in the client's hello; empty before it. */
    public String clientId() {
        return clientId;
    }

    /** Whether the client has asked to command in its newest hello, whatever it was granted. */
    public boolean wishesToCommand() {
        return wishesToCommand;
    }

    /** For how long nothing that could be read has come from the client, in ms; for one that never spoke, since the clock began. */
    public long silentForMs(long nowMs) {
        return nowMs - lastReceivedMs;
    }

    /** How often the client may ask for the command. */
    RateLimit wishes() {
        return wishes;
    }

    void setRole(Role granted, String newTerm) {
        role = Optional.of(granted);
        term = newTerm;
    }

    /** What a client that commands has to name, so that it is known to have read its welcome; empty for all others. */
    String term() {
        return term;
    }

    void greeted(Hello hello, double defaultHz) {
        clientId = hello.clientId();
        double hz = hello.telemetryHz() > 0 ? hello.telemetryHz() : defaultHz;
        telemetryPeriodMs = Math.max(1, Math.round(1000 / hz));
        nextTelemetryMs = Long.MIN_VALUE; // with the next tick
        wishesToCommand = hello.role() == Role.COMMANDER;
    }

    /** Whether nothing has come for so long that the client counts as lost. */
    boolean isSilent(long nowMs, long afterMs) {
        return silentForMs(nowMs) > afterMs;
    }

    /** Whether something was sent before another command or setting by hand of this client that has already been executed. */
    boolean isOvertaken(Frame frame) {
        return frame.sequence() <= newestExecuted;
    }

    /** Whether something was sent before the client had read the welcome by which it commands now. */
    boolean isOfAnotherTerm(Frame frame) {
        return !frame.term().equals(term);
    }

    void executed(Frame frame) {
        newestExecuted = Math.max(newestExecuted, frame.sequence());
    }

    void send(LinkMessage message, long nowMs) {
        lastSentMs = nowMs;
        toClient.send(new Frame(sequence++, "", message));
    }

    void tick(long nowMs) {
        if (!role.isPresent()) {
            return;
        }
        if (nowMs >= nextTelemetryMs && server.knowsWhereItIs()) {
            send(server.telemetry(nowMs), nowMs);
            boolean onTime = nextTelemetryMs > nowMs - telemetryPeriodMs;
            nextTelemetryMs = onTime ? nextTelemetryMs + telemetryPeriodMs : nextOfItsOwn(nowMs);
        } else if (nowMs - lastSentMs >= HEARTBEAT_MS) {
            boolean telemetryIsNext = nextTelemetryMs - nowMs <= TICK_MS && server.knowsWhereItIs();
            if (!telemetryIsNext) {
                send(new Heartbeat(nowMs), nowMs);
            }
        }
    }

    /** After its first telemetry a boat sends it at times that follow from its name, as those of a fleet that is greeted in one moment would all come at once. */
    private long nextOfItsOwn(long nowMs) {
        long sinceOwnMs = Math.floorMod(nowMs - TICK_MS * server.boatId().hashCode(), telemetryPeriodMs);
        return nowMs + telemetryPeriodMs - sinceOwnMs;
    }

    private static String shortened(String text) {
        return text.length() <= 200 ? text : text.substring(0, 200);
    }
}

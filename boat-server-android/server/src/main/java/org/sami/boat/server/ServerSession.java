package org.sami.boat.server;

import java.util.Optional;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
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
    private long lastTeleoperation = -1;
    private long lastMotion = -1;
    private long refusedFrames;
    private boolean open = true;

    ServerSession(BoatServer server, FrameSink toClient) {
        this.server = server;
        this.toClient = toClient;
    }

    /** Takes one whole frame from the client. What cannot be read is counted and, where it names a command, refused. */
    public void receive(byte[] frame, long nowMs) {
        if (!open) {
            return;
        }
        try {
            Frame read = server.codec().decode(frame);
            server.received(this, read, nowMs);
            lastReceivedMs = nowMs;
        } catch (LinkException e) {
            refusedFrames++;
            send(new Nack(e.commandId(), NackReason.MALFORMED, shortened(e.getMessage())), nowMs);
        }
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

    void setRole(Role granted) {
        role = Optional.of(granted);
    }

    void greeted(Hello hello, double defaultHz) {
        clientId = hello.clientId();
        double hz = hello.telemetryHz() > 0 ? hello.telemetryHz() : defaultHz;
        telemetryPeriodMs = Math.max(1, Math.round(1000 / hz));
        nextTelemetryMs = Long.MIN_VALUE; // with the next tick
        lastTeleoperation = -1;
        lastMotion = -1;
    }

    /** Whether nothing has come for so long that the client counts as lost. */
    boolean isSilent(long nowMs, long afterMs) {
        return nowMs - lastReceivedMs > afterMs;
    }

    /** Whether a setting by hand is newer than all before it. */
    boolean isNewestTeleoperation(long frameSequence) {
        boolean newest = frameSequence > lastTeleoperation;
        lastTeleoperation = Math.max(lastTeleoperation, frameSequence);
        return newest;
    }

    /** Whether a command was sent before another one that has already been executed. */
    boolean isOvertaken(long frameSequence) {
        return frameSequence < lastMotion;
    }

    void executed(long frameSequence) {
        lastMotion = Math.max(lastMotion, frameSequence);
    }

    void send(LinkMessage message, long nowMs) {
        lastSentMs = nowMs;
        toClient.send(server.codec().encode(sequence++, message));
    }

    void tick(long nowMs) {
        if (!role.isPresent()) {
            return;
        }
        boolean hasTelemetry = server.knowsWhereItIs();
        if (hasTelemetry && nowMs >= nextTelemetryMs) {
            send(server.telemetry(nowMs), nowMs);
            boolean onTime = nextTelemetryMs > nowMs - telemetryPeriodMs;
            nextTelemetryMs = (onTime ? nextTelemetryMs : nowMs) + telemetryPeriodMs;
        } else if (nowMs - lastSentMs >= HEARTBEAT_MS) {
            boolean telemetryIsNext = hasTelemetry && nextTelemetryMs - nowMs <= TICK_MS;
            if (!telemetryIsNext) {
                send(new Heartbeat(nowMs), nowMs);
            }
        }
    }

    private static String shortened(String text) {
        return text.length() <= 200 ? text : text.substring(0, 200);
    }
}

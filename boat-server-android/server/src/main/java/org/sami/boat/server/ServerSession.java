package org.sami.boat.server;

import java.io.IOException;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.sami.boat.link.EarlierVersion;
import org.sami.boat.link.FileRefusal;
import org.sami.boat.link.FileRequest;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Pair;
import org.sami.boat.link.RateLimit;
import org.sami.boat.link.Role;
import org.sami.boat.link.WithdrawKeys;
import org.sami.boat.link.security.Fingerprint;

/**
 * The boat's side of one client's link. Its host passes it the frames that arrive and reports when the link has closed, on the thread that ticks the
 * server.
 */
public final class ServerSession {
    private static final long TICK_MS = 100;
    private static final long HEARTBEAT_MS =
            LinkDefaults.HEARTBEAT_MS - TICK_MS; // so that it comes once a second at least

    private final BoatServer server;
    private final FrameSink toClient;
    private final FileProvider files;
    private boolean fileAsked; // and not answered
    private Optional<Role> role = Optional.empty();
    private String clientId = "";
    private String claimedSession = "";
    private long sequence;
    private long lastReceivedMs;
    private long lastSentMs;
    private long telemetryPeriodMs;
    private long nextTelemetryMs;
    private String term = "";
    private long newestExecuted = -1; // by its sequence; it outlives every hello
    private long refusedFrames;
    private String newestStop = ""; // of an observer
    private boolean wishesToCommand;
    private final RateLimit wishes = TransferRateLimits.wishesOfOne();
    private Optional<String> dismissal = Optional.empty();
    private boolean open = true;
    private Optional<BoatKeys> keys = Optional.empty(); // of a boat that speaks with protection
    private Optional<Fingerprint> key = Optional.empty();
    private long unheard;
    private BooleanSupplier disarmed = () -> false;

    ServerSession(BoatServer server, FrameSink toClient, FileProvider files) {
        this.server = server;
        this.toClient = toClient;
        this.files = files;
    }

    /** Takes one whole frame from the client. An unreadable frame is counted and, where it names a command, refused. */
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
            send(new Nack(e.commandId(), NackReason.MALFORMED, shortened(String.valueOf(e.getMessage()))), nowMs);
        }
    }

    /**
     * The link is protected, and the client has that key: it may do what the key is granted. Without this it may do everything. To be called before any
     * frame of the client.
     */
    public void protectedBy(BoatKeys boatKeys, Fingerprint clientKey) {
        keys = Optional.of(boatKeys);
        key = Optional.of(clientKey);
    }

    /**
     * The client arms and disarms the boat, and says whether it is disarmed now. A boat that it has disarmed stays at rest when the link is lost; for clients in
     * the boat's process.
     */
    public void disarmsBy(BooleanSupplier isDisarmed) {
        disarmed = isDisarmed;
    }

    /** Whether the boat is disarmed by this client. */
    boolean hasDisarmed() {
        return disarmed.getAsBoolean();
    }

    /** The most that the client may be; empty for a stranger. */
    Optional<Role> granted() {
        return keys.isPresent() ? keys.get().roleOf(key.get()) : Optional.of(Role.COMMANDER);
    }

    /** Whether the client has shown a key that this boat does not know, or knows no longer. */
    public boolean isStranger() {
        return !granted().isPresent();
    }

    /** The client's key; empty on a link without protection. */
    Optional<Fingerprint> key() {
        return key;
    }

    /** Withdraws keys for this client. */
    void withdraw(WithdrawKeys command) throws IOException {
        if (keys.isPresent()) {
            keys.get().withdraw(command, key.get());
        }
    }

    /** Number of frames of a stranger that were not looked at. */
    public long unheard() {
        return unheard;
    }

    /** A stranger learns who the boat is and may be paired, and a known base may be paired again; nothing else. */
    private void receiveFromStranger(LinkMessage message, long nowMs) {
        if (message instanceof Pair) {
            try {
                send(keys.get().pair(key.get(), (Pair) message, server.boatId(), nowMs), nowMs);
            } catch (IOException e) {
                dismiss(String.valueOf(e.getMessage()), "it was not paired: " + e.getMessage(), nowMs);
            }
        } else if (message instanceof Hello) {
            String why = keys.get().whyStranger(key.get(), server.boatId());
            dismiss(why, why, nowMs);
        } else {
            unheard++;
        }
    }

    /** Takes a frame from a client whose link carries no bytes. */
    public void receive(Frame frame, long nowMs) {
        if (takesNothing()) {
            return;
        }
        if (!granted().isPresent() || (keys.isPresent() && frame.message() instanceof Pair)) {
            receiveFromStranger(frame.message(), nowMs);
        } else {
            server.received(this, frame, nowMs);
            lastReceivedMs = nowMs;
        }
    }

    /** Whether the boat takes nothing more from this client. */
    private boolean takesNothing() {
        return !open || dismissal.isPresent();
    }

    /** Answers in the client's own frames, which it can read, and in those of this version, whose version it can read. */
    private void refuseVersion(int version, long nowMs) {
        String both = "link version " + version + ", this boat version " + LinkCodec.VERSION;
        String reason = "the base speaks " + both + ": bring both to the same version";
        toClient.send(EarlierVersion.goodbye(version, server.boatId(), reason));
        dismiss(reason, "it speaks " + both, nowMs);
    }

    /** Dismisses this client: sends it a goodbye, and lets the host drop it once that has left. */
    private void dismiss(String reason, String why, long nowMs) {
        send(new Goodbye(server.boatId(), reason), nowMs);
        dismissal = Optional.of(why);
    }

    /** Turns the client away with a reason; its host then drops it. */
    public void turnAway(String reason, long nowMs) {
        dismiss(reason, reason, nowMs);
    }

    /** Why the host drops the client once its last message has left; empty for a client that stays. */
    public Optional<String> dismissal() {
        return dismissal;
    }

    /** The link has closed. If it was the commander's, the boat's lost-link action starts at once. */
    public void closed(long nowMs) {
        if (open) {
            open = false;
            server.closed(this, nowMs);
        }
    }

    /** The client's role; empty before its hello. */
    public Optional<Role> role() {
        return role;
    }

    /** Number of unreadable frames of this client. */
    public long refusedFrames() {
        return refusedFrames;
    }

    /** The name in the client's hello; empty before it. */
    public String clientId() {
        return clientId;
    }

    /** Id of the session in the client's newest hello; empty for a client of the link of before. */
    String claimedSession() {
        return claimedSession;
    }

    /** Whether the client asked to command in its newest hello, granted or not. */
    public boolean wishesToCommand() {
        return wishesToCommand;
    }

    /** Time since the client's last readable frame, in ms; since the clock began for a client that has sent none. */
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

    /** The term that a commanding client has to name, as proof that it has read its welcome; empty for all others. */
    String term() {
        return term;
    }

    void greeted(Hello hello, double defaultHz) {
        clientId = hello.clientId();
        claimedSession = hello.session();
        double hz = hello.telemetryHz() > 0 ? hello.telemetryHz() : defaultHz;
        telemetryPeriodMs = Math.max(1, Math.round(1000 / hz));
        nextTelemetryMs = Long.MIN_VALUE; // with the next tick
        wishesToCommand = hello.role() == Role.COMMANDER;
    }

    /** Whether the client has been silent for so long that it counts as lost. */
    boolean isSilent(long nowMs, long afterMs) {
        return silentForMs(nowMs) > afterMs;
    }

    /** Whether a frame was sent before a command or hand setting of this client that has already been executed. */
    boolean isOvertaken(Frame frame) {
        return frame.sequence() <= newestExecuted;
    }

    /** Whether a frame was sent before the client had read the welcome of its present term. */
    boolean isOfAnotherTerm(Frame frame) {
        return !frame.term().equals(term);
    }

    /** Whether an observer's stop is another one than its newest before; a client repeats its stop until it is answered. */
    boolean stopsAnew(String commandId) {
        boolean isNew = !commandId.equals(newestStop);
        newestStop = commandId;
        return isNew;
    }

    void executed(Frame frame) {
        newestExecuted = Math.max(newestExecuted, frame.sequence());
    }

    void send(LinkMessage message, long nowMs) {
        lastSentMs = nowMs;
        toClient.send(new Frame(sequence++, "", message));
    }

    /** A client that has said hello gets one answer after the other, each when the boat has nothing else to say to it. */
    void askForFile(FileRequest request, long nowMs) {
        if (!role.isPresent()) {
            send(new Nack("", NackReason.NOT_GREETED, "say hello before you ask for files"), nowMs);
        } else if (fileAsked) {
            send(busy(request), nowMs);
        } else {
            fileAsked = true;
            files.asked(request, answer -> {
                fileAsked = false;
                if (open && !toClient.sendBelow(new Frame(sequence++, "", answer))) {
                    send(busy(request), nowMs);
                }
            });
        }
    }

    private static FileRefusal busy(FileRequest request) {
        return new FileRefusal(
                request.requestId(), FileRefusal.Reason.BUSY, "one request at a time: an earlier one is not answered");
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

    /** The next time for telemetry, offset by the boat's name: otherwise a fleet that is greeted at once would send all of it at once. */
    private long nextOfItsOwn(long nowMs) {
        long sinceOwnMs = Math.floorMod(nowMs - TICK_MS * server.boatId().hashCode(), telemetryPeriodMs);
        return nowMs + telemetryPeriodMs - sinceOwnMs;
    }

    private static String shortened(String text) {
        return text.length() <= 200 ? text : text.substring(0, 200);
    }
}

package org.sami.crw.proxy.link;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.Frame;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Motion;
import org.sami.boat.link.Progress;
import org.sami.boat.link.RateLimit;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Welcome;

/**
 * Limits the messages that a base accepts from one boat to several times what a working boat sends, so that a boat that sends too much takes neither
 * time nor journal from the others (docs/link.md). Answers to commands are always accepted.
 *
 * <p>Of messages about the present state the newest is kept and accepted as soon as there is room, so the last one always gets through. Others are
 * left out. Both are counted. For the proxy's thread.
 */
public final class Intake {
    /** Channels of sensors: a sonde has about ten. */
    public static final int MOST_CHANNELS = 64;

    private static final String READINGS = "readings";
    private static final String CHANNELS = "readings of channels beyond the first " + MOST_CHANNELS;
    private static final String UNREAD = "messages that were not read";
    private static final double READING_OVERHEAD = 2; // overhead of a reading, in values
    private static final long REPORT_MS = 1000;
    private static final long OVER_AFTER_MS = 10_000;

    private final Map<Class<? extends LinkMessage>, Gate> gates = new LinkedHashMap<>();
    private final RateLimit readings = new RateLimit(200, 2000);
    private final RateLimit values = new RateLimit(1000, 10_000);
    private final Set<Channel> channels = new HashSet<>();
    private final Map<String, Long> leftOut = new LinkedHashMap<>();
    private boolean active;
    private boolean news;
    private long lastMs;
    private long nextReportMs = Long.MIN_VALUE;

    private record Channel(String sensor, String channel, String unit) {}

    /** One kind of message. */
    private static final class Gate {
        private final String what;
        private final RateLimit limit;
        private final boolean keepsNewest;
        private Optional<Frame> newest = Optional.empty();

        Gate(String what, RateLimit limit, boolean keepsNewest) {
            this.what = what;
            this.limit = limit;
            this.keepsNewest = keepsNewest;
        }
    }

    /** Nothing has come yet. */
    public Intake() {
        gates.put(Telemetry.class, new Gate("poses", new RateLimit(60, 240), true));
        gates.put(Motion.class, new Gate("poses among others", new RateLimit(20, 80), false));
        gates.put(BatteryReport.class, new Gate("battery reports", new RateLimit(2, 20), true));
        gates.put(Progress.class, new Gate("reports of progress", new RateLimit(50, 500), true));
        gates.put(SettingsReport.class, new Gate("reports of settings", new RateLimit(10, 100), true));
        gates.put(Welcome.class, new Gate("welcomes", new RateLimit(5, 50), true));
        gates.put(Goodbye.class, new Gate("goodbyes", new RateLimit(1, 10), true));
        gates.put(CommandAsked.class, new Gate("wishes of others to command", new RateLimit(1, 10), false));
    }

    /** Whether a message is to be taken now. */
    public boolean takes(Frame frame, long nowMs) {
        LinkMessage message = frame.message();
        if (message instanceof SensorReport reading) {
            return takesReading(reading, nowMs);
        }
        Gate gate = gates.get(message.getClass());
        if (gate == null) {
            return true;
        }
        boolean taken = gate.limit.take(nowMs);
        boolean overtakes = gate.newest.isPresent(); // what waits is older, and is taken no more
        gate.newest = taken || !gate.keepsNewest ? Optional.empty() : Optional.of(frame);
        if (overtakes || !(taken || gate.keepsNewest)) {
            leaveOut(gate.what, 1, nowMs);
        }
        return taken;
    }

    private boolean takesReading(SensorReport reading, long nowMs) {
        Channel channel = new Channel(reading.sensor(), reading.channel(), reading.unit());
        if (channels.size() >= MOST_CHANNELS && !channels.contains(channel)) {
            leaveOut(CHANNELS, 1, nowMs);
            return false;
        }
        if (!readings.take(nowMs) || !values.take(nowMs, reading.values().size() + READING_OVERHEAD)) {
            leaveOut(READINGS, 1, nowMs);
            return false;
        }
        channels.add(channel);
        return true;
    }

    /** So many messages of the boat were left out before anybody read them. */
    public void leftOutUnread(long count, long nowMs) {
        if (count > 0) {
            leaveOut(UNREAD, count, nowMs);
        }
    }

    private void leaveOut(String what, long count, long nowMs) {
        if (!active) {
            leftOut.clear();
            nextReportMs = nowMs;
        }
        leftOut.merge(what, count, Long::sum);
        active = true;
        news = true;
        lastMs = nowMs;
    }

    /** Messages that were kept and can be taken now, in the order in which they came. */
    public List<Frame> due(long nowMs) {
        List<Frame> due = new ArrayList<>();
        for (Gate gate : gates.values()) {
            if (gate.newest.isPresent() && gate.limit.take(nowMs)) {
                due.add(gate.newest.get());
                gate.newest = Optional.empty();
            }
        }
        due.sort(Comparator.comparingLong(Frame::sequence));
        return due;
    }

    /** Forgets messages that were kept: they came over a link that is gone. */
    public void linkEnded() {
        gates.values().forEach(gate -> gate.newest = Optional.empty());
    }

    /** The report about messages left out: at once, then once a second while their number grows, and at the end. */
    public Optional<LeftOut> news(long nowMs) {
        Supplier<LeftOut> now = () -> new LeftOut(active, leftOut);
        if (active && nowMs - lastMs >= OVER_AFTER_MS) {
            active = false;
            news = false;
            return Optional.of(now.get());
        }
        if (news && nowMs >= nextReportMs) {
            news = false;
            nextReportMs = nowMs + REPORT_MS;
            return Optional.of(now.get());
        }
        return Optional.empty();
    }
}

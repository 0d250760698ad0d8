package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.ardupilotmega.CameraFeedback;
import io.dronefleet.mavlink.ardupilotmega.EkfStatusReport;
import io.dronefleet.mavlink.common.AutopilotVersion;
import io.dronefleet.mavlink.common.FenceStatus;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.GpsRawInt;
import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.MissionItemReached;
import io.dronefleet.mavlink.common.ParamValue;
import io.dronefleet.mavlink.common.RcChannels;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.mavlink.address.MavlinkAddress;

/** Gathers what one vehicle reports. */
final class VehicleRecord {
    private static final int TEXTS = 100; // kept of each vehicle
    private static final double DEGREES = 1e-7; // of a position's whole numbers
    private static final double FROM_MILLI = 1e-3;
    private static final double FROM_CENTI = 1e-2;
    private static final int HEADING_NOT_KNOWN = 65_535;
    private static final int VOLTS_NOT_KNOWN = 65_535;
    private static final int SATELLITES_NOT_KNOWN = 255;
    private static final double FULL_CIRCLE_DEG = 360;
    private static final int FULL_PERCENT = 100;
    private static final long POSITION_MS = 5_000; // a position that is older says no longer where it is
    private static final long SILENT_MS = 3_000; // after which another vehicle may answer
    private static final long SHARED_ID_MS = 10_000; // in which one of two with the id may not have been heard
    private static final int ABSOLUTE_POSITION = 16; // of the filter's flags
    private static final int NO_POSITION = 128;

    private static final int MOST_ITEMS = 10_000; // more fits into no autopilot
    private static final double MAX_LAT = 90;
    private static final double MAX_LON = 180;
    private static final int NO_ITEMS =
            65_535; // how an empty mission is written, as 0 is for firmwares that do not say

    private final VehicleId id;
    private final LinkChoice links = new LinkChoice();
    private final DuplicateIdDetector duplicates = new DuplicateIdDetector();
    private final BootClock bootClock = new BootClock();
    private final OwnLinks own;
    private final RepeatedNews repeated = new RepeatedNews();
    private final Map<MavlinkAddress, StatusTextParts> parts = new HashMap<>();
    private final Deque<StatusText> texts = new ArrayDeque<>();
    private MavType type = MavType.MAV_TYPE_GENERIC;
    private MavAutopilot autopilot = MavAutopilot.MAV_AUTOPILOT_GENERIC;
    private long customMode;
    private boolean armed;
    private boolean located;
    private Optional<VehiclePosition> position = Optional.empty();
    private Optional<VehicleBattery> battery = Optional.empty();
    private Optional<GpsState> gps = Optional.empty();
    private VehicleHealth health = VehicleHealth.unknown();
    private Optional<Integer> currentItem = Optional.empty();
    private Optional<Integer> itemsHeld = Optional.empty();
    private boolean beaten;
    private VehicleKind kind = VehicleKind.OTHER; // for which it is taken
    private Optional<String> number = Optional.empty(); // of the autopilot for which it is taken
    private boolean toldSharedId; // that two vehicles have the id
    private boolean numberSaid; // since it was silent or has started again
    private long mayFlyMs = Long.MIN_VALUE / 2; // when it last said that it is something that may fly
    private long beatMs;
    private long heardMs;
    private long positionMs; // when it said last where it is, or was heard first

    VehicleRecord(VehicleId id, long nowMs) {
        this.id = id;
        own = new OwnLinks(id);
        positionMs = nowMs;
    }

    /** Takes a message; what happened by it. What comes from another vehicle with this id, on another link, is not taken. */
    List<VehicleEvent> heard(MessageOrigin from, Object payload, long nowMs) {
        List<VehicleEvent> events = new ArrayList<>();
        if (!own.isOwn(from.link(), payload, nowMs, events)) {
            return events;
        }
        numberSaid = (numberSaid && nowMs - heardMs <= SILENT_MS) || payload instanceof AutopilotVersion;
        heardMs = nowMs;
        links.heard(from.link(), from.number(), nowMs)
                .map(change -> new VehicleEvent.LinkChanged(id, change.before(), change.now(), change.why()))
                .ifPresent(events::add);
        if (payload instanceof Statustext text) { // the next three come once on each link
            parts.computeIfAbsent(from.link(), link -> new StatusTextParts())
                    .take(text, nowMs)
                    .forEach(whole -> said(whole, from.link(), events));
        } else if (payload instanceof MissionItemReached reached) {
            if (reached.seq() < MOST_ITEMS && !repeated.isRepeated("item " + reached.seq(), from.link(), nowMs)) {
                events.add(new VehicleEvent.ItemReached(id, reached.seq(), position, nowMs));
            }
        } else if (payload instanceof CameraFeedback picture) {
            if (!repeated.isRepeated("picture " + picture.imgIdx(), from.link(), nowMs)) {
                taken(picture).ifPresent(events::add);
            }
        } else if (links.isNews(from.link(), nowMs)) {
            take(payload, nowMs, events);
        }
        if (sharesId() && !toldSharedId) {
            events.add(new VehicleEvent.SharedId(id, from.link()));
        }
        toldSharedId = sharesId();
        if (payload instanceof Heartbeat || payload instanceof AutopilotVersion) {
            compare(events);
        }
        return events;
    }

    /** Lets time pass: a text whose other parts have not come is taken as far as it has. */
    List<VehicleEvent> tick(long nowMs) {
        List<VehicleEvent> events = new ArrayList<>();
        parts.forEach((link, open) ->
                open.overdue(nowMs).filter(text -> !isToldWhole(text)).ifPresent(text -> said(text, link, events)));
        return events;
    }

    /** Whether more of a text has come on another link. */
    private boolean isToldWhole(StatusText cut) {
        return texts.stream()
                .anyMatch(told -> cut.heardMs() - told.heardMs() <= RepeatedNews.WITHIN_MS
                        && told.text().startsWith(StatusTextParts.withoutMark(cut.text())));
    }

    /** Whether it is still what it was taken for. While two vehicles have the id, that is no news. */
    private void compare(List<VehicleEvent> events) {
        if (sharesId()) {
            return;
        }
        VehicleKind said = VehicleKind.of(type);
        boolean isOfKind = said.canBe(kind);
        Optional<String> now = numberSaid ? own.number() : Optional.empty();
        boolean isAnother = number.isPresent() && now.isPresent() && !now.equals(number);
        if (!isOfKind || isAnother) {
            events.add(new VehicleEvent.Replaced(id, kind, said));
            forget();
            duplicates.replaced(!isOfKind, heardMs);
            numberSaid &= isOfKind; // it may be the number of the one before
        }
        kind = said == VehicleKind.OTHER ? kind : said;
        number = numberSaid ? now.or(() -> number) : number;
    }

    /** What was known of the vehicle before says nothing of this one. */
    private void forget() {
        located = false;
        position = Optional.empty();
        battery = Optional.empty();
        gps = Optional.empty();
        health = VehicleHealth.unknown();
        currentItem = Optional.empty();
        itemsHeld = Optional.empty();
        texts.clear();
        number = Optional.empty();
        bootClock.restarted();
    }

    /** Takes how it is now. */
    private void take(Object payload, long nowMs, List<VehicleEvent> events) {
        if (payload instanceof Heartbeat beat) {
            beat(beat, events);
        } else if (payload instanceof GlobalPositionInt at) {
            positionMs = nowMs;
            position = position(at, nowMs);
            position.ifPresent(place -> duplicates.at(place.latDeg(), place.lonDeg(), nowMs));
            clock(at.timeBootMs(), nowMs, events);
        } else if (payload instanceof SysStatus status) {
            battery = Optional.of(battery(status));
            health = health.with(status);
        } else if (payload instanceof GpsRawInt raw) {
            gps = Optional.of(gps(raw));
        } else if (payload instanceof EkfStatusReport filter) {
            int flags = filter.flags().value();
            located = (flags & ABSOLUTE_POSITION) != 0 && (flags & NO_POSITION) == 0;
        } else if (payload instanceof FenceStatus fence) {
            health = health.withFence(fence.breachStatus() != 0);
        } else if (payload instanceof MissionCurrent current && current.seq() < MOST_ITEMS) {
            current(current, nowMs, events);
        } else if (payload instanceof RcChannels radio) {
            events.add(new VehicleEvent.RadioHeard(id, RadioPulses.of(radio)));
        } else if (payload instanceof ParamValue parameter) {
            events.add(new VehicleEvent.ParameterReported(id, parameter.paramId(), parameter.paramValue()));
        } else {
            VehicleReadings.of(payload).forEach(reading -> events.add(new VehicleEvent.Measured(id, reading)));
        }
    }

    private void clock(long bootMs, long nowMs, List<VehicleEvent> events) {
        if (duplicates.restarted(bootMs, nowMs)) {
            if (!sharesId()) {
                restarted();
                events.add(new VehicleEvent.Restarted(id));
            }
        } else if (bootClock.isBehind(bootMs, nowMs) && !sharesId()) {
            events.add(new VehicleEvent.ClockBehind(id));
        }
    }

    /** Its autopilot has started again: it does not know where it is. */
    void restarted() {
        located = false;
        numberSaid = false;
        bootClock.restarted();
    }

    /** A picture at its own place, or where it has none (0, 0) at the vehicle's; none where neither is known. */
    private Optional<VehicleEvent> taken(CameraFeedback picture) {
        if (picture.lat() == 0 && picture.lng() == 0) {
            return position.map(at -> new VehicleEvent.PictureTaken(id, picture.imgIdx(), at.latDeg(), at.lonDeg()));
        }
        return Optional.of(
                new VehicleEvent.PictureTaken(id, picture.imgIdx(), picture.lat() * DEGREES, picture.lng() * DEGREES));
    }

    private void current(MissionCurrent current, long nowMs, List<VehicleEvent> events) {
        Optional<Integer> item = Optional.of(current.seq());
        if (!item.equals(currentItem)) {
            events.add(new VehicleEvent.ItemCurrent(id, current.seq(), nowMs));
        }
        currentItem = item;
        itemsHeld = current.total() == 0
                ? Optional.empty() // an older firmware does not send it
                : Optional.of(current.total() == NO_ITEMS ? 0 : current.total());
    }

    Optional<Long> modeNumber(String mode) {
        return ModeNames.number(autopilot, VehicleKind.of(type), mode);
    }

    private void beat(Heartbeat beat, List<VehicleEvent> events) {
        String modeBefore = mode();
        boolean armedBefore = armed;
        beatMs = heardMs;
        MavType what = beat.type().entry();
        MavAutopilot whose = beat.autopilot().entry();
        type = what == null ? MavType.MAV_TYPE_GENERIC : what;
        autopilot = whose == null ? MavAutopilot.MAV_AUTOPILOT_GENERIC : whose;
        customMode = beat.customMode();
        mayFlyMs = VehicleKind.of(type).mayFly() ? heardMs : mayFlyMs;
        armed = beat.baseMode().flagsEnabled(MavModeFlag.MAV_MODE_FLAG_SAFETY_ARMED);
        MavState state = beat.systemStatus().entry();
        health = health.withFailsafe(state == MavState.MAV_STATE_CRITICAL || state == MavState.MAV_STATE_EMERGENCY);
        if (beaten && !mode().equals(modeBefore)) {
            events.add(new VehicleEvent.ModeChanged(id, modeBefore, mode()));
        }
        if (beaten && armed != armedBefore) {
            events.add(new VehicleEvent.ArmedChanged(id, armed));
        }
        beaten = true;
    }

    private String mode() {
        return ModeNames.of(autopilot, VehicleKind.of(type), customMode);
    }

    /** Whether it is to be asked for the number of its autopilot. */
    boolean isNumberOpen() {
        return !numberSaid;
    }

    /** Whether it may fall where its motors are turned off: it flies, so does another vehicle with its id, or it was not heard just now and may be another one. */
    boolean mayFly(long nowMs) {
        return nowMs - mayFlyMs <= SHARED_ID_MS || nowMs - beatMs > SILENT_MS;
    }

    /** Whether two vehicles have this id, as far as the last seconds show. */
    boolean sharesId() {
        return duplicates.isDuplicate(heardMs);
    }

    /** When it was heard last. */
    long heardMs() {
        return heardMs;
    }

    /** Whether it goes on speaking without saying where it is. */
    boolean isPositionOld() {
        return heardMs - positionMs > POSITION_MS;
    }

    /** Where it is; empty where that is no place, as 0, 0 is none before there is a fix. */
    private static Optional<VehiclePosition> position(GlobalPositionInt at, long nowMs) {
        double lat = at.lat() * DEGREES;
        double lon = at.lon() * DEGREES;
        if ((at.lat() == 0 && at.lon() == 0) || Math.abs(lat) > MAX_LAT || Math.abs(lon) > MAX_LON) {
            return Optional.empty();
        }
        Optional<Double> heading =
                at.hdg() == HEADING_NOT_KNOWN ? Optional.empty() : Optional.of(at.hdg() * FROM_CENTI % FULL_CIRCLE_DEG);
        return Optional.of(new VehiclePosition(
                lat,
                lon,
                at.relativeAlt() * FROM_MILLI,
                Math.hypot(at.vx(), at.vy()) * FROM_CENTI,
                heading,
                nowMs,
                at.timeBootMs()));
    }

    private static VehicleBattery battery(SysStatus status) {
        return new VehicleBattery(
                status.voltageBattery() == VOLTS_NOT_KNOWN
                        ? Optional.empty()
                        : Optional.of(status.voltageBattery() * FROM_MILLI),
                status.batteryRemaining() < 0 || status.batteryRemaining() > FULL_PERCENT
                        ? Optional.empty()
                        : Optional.of(status.batteryRemaining()));
    }

    private static GpsState gps(GpsRawInt raw) {
        return new GpsState(
                fix(raw.fixType().value()),
                raw.satellitesVisible() == SATELLITES_NOT_KNOWN
                        ? Optional.empty()
                        : Optional.of(raw.satellitesVisible()));
    }

    private static String fix(int type) {
        return switch (type) {
            case 0 -> "no GPS";
            case 1 -> "no fix";
            case 2 -> "2D";
            case 3 -> "3D";
            case 4 -> "DGPS";
            case 5 -> "RTK float";
            case 6 -> "RTK fixed";
            default -> "fix of kind " + type;
        };
    }

    private void said(StatusText text, MavlinkAddress link, List<VehicleEvent> events) {
        if (repeated.isRepeated(text.severity() + " " + text.text(), link, text.heardMs())) {
            return;
        }
        events.add(new VehicleEvent.Said(id, text));
        if (texts.size() == TEXTS) {
            texts.removeFirst();
        }
        texts.addLast(text);
    }

    /** @param stations other ground stations on its links */
    VehicleSnapshot snapshot(OtherStations stations) {
        return new VehicleSnapshot(
                id,
                VehicleKind.of(type),
                autopilotName(),
                mode(),
                armed,
                located && !isPositionOld(),
                position,
                battery,
                gps,
                healthNow(),
                currentItem,
                itemsHeld,
                links.links(heardMs),
                own.others(),
                own.unsettled(),
                List.copyOf(texts),
                heardMs,
                stations.on(own.links(), heardMs),
                numberSaid ? Optional.of(own.number().orElse("")) : Optional.empty());
    }

    private VehicleHealth healthNow() {
        VehicleHealth now = sharesId() ? health.withSharedId(id) : health;
        for (MavlinkAddress link : own.others()) {
            now = now.withOther(id, link);
        }
        return now;
    }

    /** One of its links may have been replaced by another one at the same port. */
    void moved(MavlinkAddress before, MavlinkAddress now) {
        own.moved(before, now);
        links.moved(before, now);
    }

    OwnLinks own() {
        return own;
    }

    LinkChoice links() {
        return links;
    }

    private String autopilotName() {
        return switch (autopilot) {
            case MAV_AUTOPILOT_ARDUPILOTMEGA -> "ArduPilot";
            case MAV_AUTOPILOT_PX4 -> "PX4";
            default ->
                autopilot
                        .name()
                        .substring("MAV_AUTOPILOT_".length())
                        .toLowerCase(Locale.ROOT)
                        .replace('_', ' ');
        };
    }
}

package org.sami.boat.mavlink;

import java.util.Optional;
import java.util.function.Consumer;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LinkDefaults;
import org.sami.mavlink.vehicle.TextSeverity;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Which ground station commands the boat, if any. A base of ours comes first: while it commands, and for some time after its link was lost, stations only watch;
 * a station that wants to command has the base's operator asked. For the boat's thread.
 */
final class CommandingStation {
    /** For so long after its link was lost a base keeps the command, in ms: a short break of a radio hands nothing over. */
    static final long KEPT_MS = 30_000;

    private static final long WISH_AGAIN_MS = 30_000;

    /** Says something to the people at ground stations. */
    interface Voice {
        void say(TextSeverity severity, String text);
    }

    private final BoatClient boat;
    private final String name;
    private final Voice voice;
    private final Consumer<Boolean> commandChanged;
    private Optional<VehicleId> holder = Optional.empty();
    private long holderHeardMs;
    private Optional<VehicleId> wisher = Optional.empty(); // that asked for the command last
    private long wisherHeardMs;
    private Optional<String> base = Optional.empty();
    private long baseSeenMs;
    private long wishedMs = Long.MIN_VALUE;
    private boolean commanded;

    /**
     * Nobody commands from a ground station.
     *
     * @param commandChanged receives whether ground stations command the boat, at each change
     */
    CommandingStation(BoatClient boat, String name, Voice voice, Consumer<Boolean> commandChanged, long nowMs) {
        this.boat = boat;
        this.name = name;
        this.voice = voice;
        this.commandChanged = commandChanged;
        base = boat.lastCommander(); // of an earlier start: it may be on its way back
        baseSeenMs = nowMs;
    }

    /** A station was heard; the one that commands keeps the boat's link alive by that, and any while a base commands, which may hand over at any time. */
    void heard(VehicleId station, long nowMs) {
        if (wisher.equals(Optional.of(station))) {
            wisherHeardMs = nowMs;
        }
        if (boat.commands() && commanded && holder.isEmpty()) { // a base has handed over without having been asked
            holder = Optional.of(station);
        }
        boolean holds = holder.equals(Optional.of(station));
        if (holds) {
            holderHeardMs = nowMs;
        }
        if (boat.otherCommander().isPresent() || (holds && boat.commands())) {
            boat.alive(nowMs);
        }
    }

    /** Whether this station commands the boat. */
    boolean isHolder(VehicleId station) {
        return boat.commands() && holder.equals(Optional.of(station));
    }

    /** Why a station may not command now; empty where it does, from now on. */
    Optional<String> take(VehicleId station, long nowMs) {
        watch(nowMs);
        Optional<String> refused = whyNot(station, nowMs);
        if (refused.isPresent()) {
            wishIfCommanded(station, nowMs);
            return refused;
        }
        wisher = Optional.of(station);
        wisherHeardMs = nowMs;
        if (!boat.commands() && !boat.takeVacant(nowMs)) {
            return Optional.of(name + " grants the command to nobody now");
        }
        holder = Optional.of(station);
        holderHeardMs = nowMs;
        watch(nowMs);
        return Optional.empty();
    }

    /** Why a station could not take the command now; changes nothing and asks nobody. */
    Optional<String> whyNot(VehicleId station, long nowMs) {
        if (boat.commands()) {
            boolean otherIsThere = holder.isPresent()
                    && !holder.get().equals(station)
                    && nowMs - holderHeardMs <= LinkDefaults.LINK_LOST_AFTER_MS;
            return otherIsThere
                    ? Optional.of("ground station " + words(holder.get()) + " commands " + name)
                    : Optional.empty();
        }
        Optional<String> other = boat.otherCommander();
        if (other.isPresent()) {
            return Optional.of(other.get() + " commands " + name + ": its operator can hand over");
        }
        long goneMs = nowMs - baseSeenMs;
        return base.isPresent() && goneMs < KEPT_MS
                ? Optional.of(base.get() + " commands " + name + ", lost " + goneMs / 1000 + " s ago: not before "
                        + KEPT_MS / 1000 + " s")
                : Optional.empty();
    }

    private void wishIfCommanded(VehicleId station, long nowMs) {
        if (boat.otherCommander().isEmpty()) {
            return;
        }
        wisher = Optional.of(station);
        wisherHeardMs = nowMs;
        if (wishedMs == Long.MIN_VALUE || nowMs - wishedMs >= WISH_AGAIN_MS) {
            wishedMs = nowMs;
            boat.wish(nowMs);
        }
    }

    private static String words(VehicleId station) {
        return station.system() + "/" + station.component();
    }

    /** Looks who commands, and says so where it has changed. */
    void watch(long nowMs) {
        Optional<String> other = boat.otherCommander();
        if (other.isPresent()) {
            if (!other.equals(base)) {
                voice.say(TextSeverity.NOTICE, other.get() + " commands " + name + "; ground stations watch");
            }
            base = other;
            baseSeenMs = nowMs;
        }
        boolean now = boat.commands();
        if (now != commanded) {
            commanded = now;
            if (now) {
                holder = wisher.filter(station -> nowMs - wisherHeardMs <= LinkDefaults.LINK_LOST_AFTER_MS);
                holderHeardMs = nowMs;
                base = Optional.empty();
                voice.say(TextSeverity.NOTICE, "ground stations command " + name);
            } else if (boat.isLost()) {
                voice.say(
                        TextSeverity.CRITICAL,
                        "ground station lost: " + name
                                + (boat.mode() == BoatMode.STOPPED
                                        ? " has its motors off"
                                        : " does what is set for that"));
            }
            commandChanged.accept(now);
        }
    }
}

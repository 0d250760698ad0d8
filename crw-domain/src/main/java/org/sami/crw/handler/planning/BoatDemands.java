package org.sami.crw.handler.planning;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.sami.boat.link.BoatCapabilities;
import org.sami.crw.handler.boat.SetGainsHandler;
import org.sami.crw.handler.motion.PanoramaHandler;
import org.sami.crw.handler.subscription.BatterySubscriptions;
import org.sami.crw.handler.subscription.MeasurementHandler;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * What output events of every domain demand of a boat beyond driving, and why a boat cannot do it. A boat that does not say what it can do is taken to be able. What
 * events of other domains demand, their modules say.
 */
public final class BoatDemands {
    /** The word with which tasks need a camera. */
    static final String CAMERA = "camera";

    /** The word for what only robots that fly offer. */
    public static final String FLIGHT = "flight";

    /** The word for what only robots on the water offer. */
    public static final String WATER = "water";

    /** What an event may demand of a robot in addition to moving. */
    public enum Demand {
        /** Pictures all round. */
        PANORAMA,
        /** Gains that the base sets. */
        GAINS,
        /** Reports of what a detector on board sees. */
        TARGETS,
        /** Reports of its charge. */
        CHARGE,
        /** Reports of how strong the wind is. */
        WIND
    }

    private static final String TARGET = "target"; // the channel of such reports
    private static final String WIND = "wind"; // the same

    private static final Map<String, String> WORDS = Map.of(
            BoatCapabilities.PANORAMA,
            "take pictures all round",
            BoatCapabilities.GAINS,
            "take gains from here",
            BoatCapabilities.CHARGE,
            "report its charge");
    private static final Map<String, Demand> BY_EVENT = Map.of(
            PanoramaHandler.TYPE,
            Demand.PANORAMA,
            SetGainsHandler.TYPE,
            Demand.GAINS,
            BatterySubscriptions.TYPE,
            Demand.CHARGE);

    private BoatDemands() {}

    /**
     * Why a boat cannot do what an output event asks of it, as a sentence without its full stop; empty where it can, or does not say.
     *
     * @param event the event's type
     * @param values of its fields, as far as they are known
     */
    public static Optional<String> missing(
            String boat, BoatCapabilities boatCan, String event, Map<String, Value> values) {
        if (event.equals(MeasurementHandler.TYPE)
                && values.get(MeasurementHandler.SENSOR) instanceof TextValue sensor) {
            return unmeasured(boatCan, sensor.value())
                    .map(why -> boat + " cannot measure " + sensor.value() + ": " + why);
        }
        return Optional.ofNullable(BY_EVENT.get(event)).flatMap(demand -> missing(boat, boatCan, demand));
    }

    /** Why a robot cannot do what is demanded of it, as a sentence without its full stop; empty where it can, or does not say. */
    public static Optional<String> missing(String robot, BoatCapabilities robotCan, Demand demand) {
        Optional<String> why = switch (demand) {
            case PANORAMA -> cannot(robotCan, BoatCapabilities.PANORAMA);
            case GAINS -> cannot(robotCan, BoatCapabilities.GAINS);
            case TARGETS -> seesNone(robotCan);
            case CHARGE -> cannot(robotCan, BoatCapabilities.CHARGE);
            case WIND -> measuresNoWind(robotCan);
        };
        return why.map(text -> robot + " " + text);
    }

    /**
     * Vehicles do not say what they are going to measure, and what detects targets may be a camera of which the autopilot does not know: it is only likely that
     * one without a camera sees none.
     */
    private static Optional<String> seesNone(BoatCapabilities robotCan) {
        return reports(robotCan, TARGET)
                ? Optional.empty()
                : Optional.ofNullable(robotCan.cannot().get(BoatCapabilities.PANORAMA))
                        .map(why -> "may see no targets" + (why.isEmpty() ? "" : ": " + why));
    }

    /** Vehicles estimate the wind in flight, if at all: of one that has not reported it yet it is only likely that it will not. */
    private static Optional<String> measuresNoWind(BoatCapabilities robotCan) {
        return reports(robotCan, WIND) || !robotCan.isKnown()
                ? Optional.empty()
                : Optional.of("may measure no wind: it has reported none so far");
    }

    private static boolean reports(BoatCapabilities robotCan, String channel) {
        return robotCan.measures()
                .filter(channels -> channels.stream().anyMatch(one -> isOf(one, channel)))
                .isPresent();
    }

    private static Optional<String> unmeasured(BoatCapabilities boatCan, String sensor) {
        return boatCan.measures()
                .filter(channels -> channels.stream().noneMatch(channel -> isOf(channel, sensor)))
                .map(channels -> channels.isEmpty() ? "it has no sensors" : "it has " + String.join(", ", channels));
    }

    /** Whether a plan names a channel so: by its sensor, by what it measures, or both. */
    private static boolean isOf(String channel, String named) {
        int slash = channel.indexOf('/');
        return channel.equals(named)
                || channel.substring(0, Math.max(0, slash)).equals(named)
                || channel.substring(slash + 1).equals(named);
    }

    private static Optional<String> cannot(BoatCapabilities boatCan, String what) {
        return Optional.ofNullable(boatCan.cannot().get(what))
                .map(why -> "cannot " + Optional.ofNullable(WORDS.get(what)).orElse(what)
                        + (why.isEmpty() ? "" : ": " + why));
    }

    /** What a boat lacks for what plans may ask, each as {@code cannot take pictures all round: there is no camera on board}; gains are no equipment. */
    public static List<String> missingEquipment(BoatCapabilities boatCan) {
        return cannot(boatCan, BoatCapabilities.PANORAMA).stream().toList();
    }

    /**
     * What a robot offers to tasks that need something, with the word for where it moves: {@link #FLIGHT} or {@link #WATER}.
     *
     * @param stated by the plan
     * @param flies whether the robot does
     */
    public static Set<String> offers(Set<String> stated, BoatCapabilities robotCan, boolean flies) {
        Set<String> offers = offers(stated, robotCan);
        offers.add(flies ? FLIGHT : WATER);
        return offers;
    }

    /**
     * What a boat offers to tasks that need something: what the plan says, and what the boat itself says.
     *
     * @param stated by the plan
     */
    static Set<String> offers(Set<String> stated, BoatCapabilities boatCan) {
        Set<String> offers = new TreeSet<>(stated);
        if (boatCan.cannot().containsKey(BoatCapabilities.PANORAMA)) {
            offers.remove(CAMERA);
        } else if (boatCan.isKnown()) {
            offers.add(CAMERA);
        }
        boatCan.measures()
                .ifPresent(channels -> channels.forEach(channel -> {
                    offers.add(channel);
                    offers.add(channel.substring(channel.indexOf('/') + 1));
                }));
        return offers;
    }
}

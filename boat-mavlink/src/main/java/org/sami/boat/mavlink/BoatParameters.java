package org.sami.boat.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.mavlink.onboard.OnboardParameter;
import org.sami.mavlink.onboard.OrderReply;

/**
 * What of a boat is a parameter: its speed, what it does when the link is lost, its gains, and, only to be read, its radii and its id. Those that ArduPilot's boats
 * have too are named as there and mean the same. For the boat's thread.
 */
final class BoatParameters {
    /** The fastest that a station may ask for, m/s. */
    static final double MOST_MPS = 20;

    private static final double LEAST_MPS = 0.1;
    private static final double MOST_GAIN = 100;
    private static final double MS = 1000;
    private static final String SPEED = "CRUISE_SPEED";
    private static final String LOST = "FS_GCS_ENABLE";
    private static final String LOST_ACTION = "FS_ACTION";
    private static final List<String> GAINS = List.of("HDG_P", "HDG_I", "HDG_D", "SPD_P", "SPD_I", "SPD_D");
    /** ArduPilot's numbers of the actions; its HOLD is motors at rest. */
    private static final Map<Integer, LostLinkAction> ACTIONS =
            Map.of(1, LostLinkAction.RETURN, 2, LostLinkAction.DRIFT, 6, LostLinkAction.HOLD);

    private final BoatClient boat;
    private final int system;
    private double speedMps = MotionDefaults.CRUISE_SPEED_MPS;
    private LostLinkAction whereOn = LostLinkAction.HOLD; // what the boat does once the failsafe is switched on again

    BoatParameters(BoatClient boat, int system) {
        this.boat = boat;
        this.system = system;
    }

    /** Speed in m/s of legs and places for which none is named. */
    double speedMps() {
        return speedMps;
    }

    void setSpeedMps(double mps) {
        speedMps = Math.min(MOST_MPS, mps);
    }

    List<OnboardParameter> all() {
        List<OnboardParameter> all = new ArrayList<>();
        all.add(new OnboardParameter("SYSID_THISMAV", system));
        all.add(new OnboardParameter(SPEED, speedMps));
        LostLinkAction now = lostLink();
        all.add(new OnboardParameter(LOST, now == LostLinkAction.CONTINUE ? 0 : 1));
        all.add(new OnboardParameter(LOST_ACTION, number(now == LostLinkAction.CONTINUE ? whereOn : now)));
        all.add(new OnboardParameter("FS_TIMEOUT", LinkDefaults.LINK_LOST_AFTER_MS / MS));
        all.add(new OnboardParameter("WP_RADIUS", MotionDefaults.ARRIVAL_RADIUS_M));
        all.add(new OnboardParameter("LOIT_RADIUS", MotionDefaults.HOLD_RADIUS_M));
        for (String name : GAINS) {
            all.add(new OnboardParameter(name, value(gains(axis(name)), name)));
        }
        return all;
    }

    private LostLinkAction lostLink() {
        return boat.settings().map(set -> set.lostLinkAction()).orElse(LostLinkAction.HOLD);
    }

    private static int number(LostLinkAction action) {
        return ACTIONS.entrySet().stream()
                .filter(each -> each.getValue() == action)
                .map(Map.Entry::getKey)
                .findFirst()
                .orElseThrow();
    }

    private static GainAxis axis(String name) {
        return name.startsWith("HDG") ? GainAxis.HEADING : GainAxis.SPEED;
    }

    private Gains gains(GainAxis axis) {
        return boat.settings().map(set -> set.gains(axis)).orElse(new Gains(0, 0, 0));
    }

    private static double value(Gains gains, String name) {
        return switch (name.charAt(name.length() - 1)) {
            case 'P' -> gains.proportional();
            case 'I' -> gains.integral();
            default -> gains.derivative();
        };
    }

    /** Whether setting it changes what only a commander may change. */
    static boolean needsCommand(String name) {
        return name.equals(LOST) || name.equals(LOST_ACTION) || GAINS.contains(name);
    }

    /** What is wrong with a value whoever commands; a value that cannot be set takes no command. */
    static Optional<String> whyWrong(String name, double value) {
        if (name.equals(SPEED)) {
            return whyOutside(name, value, LEAST_MPS, MOST_MPS);
        } else if (name.equals(LOST)) {
            return value == 0 || value == 1 ? Optional.empty() : Optional.of(LOST + " is 0 or 1, not " + value);
        } else if (name.equals(LOST_ACTION)) {
            return value == Math.rint(value) && ACTIONS.containsKey((int) value)
                    ? Optional.empty()
                    : Optional.of(LOST_ACTION + " is 1 (return), 2 (motors off) or 6 (keep the place), not " + value);
        }
        return GAINS.contains(name) ? whyOutside(name, value, 0, MOST_GAIN) : Optional.of(name + " can only be read");
    }

    /** What is wrong with a speed that is ordered, in m/s. */
    static Optional<String> whyNoSpeed(double mps) {
        return whyOutside("a speed", mps, LEAST_MPS, MOST_MPS);
    }

    private static Optional<String> whyOutside(String name, double value, double least, double most) {
        return value >= least && value <= most
                ? Optional.empty()
                : Optional.of(name + " is " + least + " to " + most + ", not " + value);
    }

    /** Sets a parameter of these; the station commands the boat where that is needed. */
    OrderReply set(String name, double value, long nowMs) {
        return whyWrong(name, value)
                .map(OrderReply::denied)
                .orElseGet(() ->
                        whyNotSet(name, value, nowMs).map(OrderReply::failed).orElse(OrderReply.ACCEPTED));
    }

    /** Sets it to a value that can be; why the boat refuses it, empty where it is done. */
    private Optional<String> whyNotSet(String name, double value, long nowMs) {
        LostLinkAction now = lostLink();
        if (name.equals(SPEED)) {
            speedMps = value;
            return Optional.empty();
        } else if (name.equals(LOST)) {
            if (now != LostLinkAction.CONTINUE) {
                whereOn = now; // as the boat was started with it, or a base set it
            }
            return send(value == 0 ? LostLinkAction.CONTINUE : whereOn, nowMs);
        } else if (name.equals(LOST_ACTION)) {
            LostLinkAction next = Objects.requireNonNull(ACTIONS.get((int) value));
            whereOn = next;
            return now == LostLinkAction.CONTINUE ? Optional.empty() : send(next, nowMs);
        }
        return boat.send(id -> gain(id, name, value), nowMs);
    }

    private Optional<String> send(LostLinkAction action, long nowMs) {
        return boat.send(id -> new SetLostLinkAction(id, action), nowMs);
    }

    private CommandMessage gain(String commandId, String name, double value) {
        GainAxis axis = axis(name);
        Gains now = gains(axis);
        Gains next = switch (name.charAt(name.length() - 1)) {
            case 'P' -> new Gains(value, now.integral(), now.derivative());
            case 'I' -> new Gains(now.proportional(), value, now.derivative());
            default -> new Gains(now.proportional(), now.integral(), value);
        };
        return new SetGains(commandId, axis, next);
    }
}

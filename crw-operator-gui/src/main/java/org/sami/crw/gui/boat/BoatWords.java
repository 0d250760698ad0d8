package org.sami.crw.gui.boat;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.LinkDefaults;
import org.sami.crw.operator.alarm.UnknownCharge;
import org.sami.crw.operator.boat.Age;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.status.LinkState;
import org.sami.palette.SemanticColor;

/** What lists and panels say of a boat, and in which colour. Values that came over the link carry their age. */
public final class BoatWords {
    /** After so many ms without a frame what is known of a boat is stale. */
    public static final long STALE_MS = LinkDefaults.LINK_LOST_AFTER_MS;

    private static final String UNKNOWN = "–";

    private BoatWords() {}

    /** How much a boat wants attention: 3 = now, 0 = not at all. */
    public static int trouble(BoatSnapshot boat) {
        if (boat.link() == LinkState.LOST
                || boat.battery().map(b -> b.level() == BatteryLevel.CRITICAL).orElse(false)) {
            return 3;
        }
        return switch (boat.why().cause()) {
            case STARTED_ANEW, REFUSES, BATTERY_EMPTY, NO_PROGRESS, FLEET_STOPPED -> 3;
            case FAILED, COMMANDED_ELSEWHERE, NEVER_ANSWERED, LINK_LOST, OTHER_KIND -> 2;
            default -> boat.battery().map(b -> b.level() == BatteryLevel.LOW).orElse(false) ? 1 : 0;
        };
    }

    /** The colour of a trouble. */
    public static SemanticColor color(int trouble) {
        return switch (trouble) {
            case 0 -> SemanticColor.TEXT;
            case 1, 2 -> SemanticColor.WARNING;
            default -> SemanticColor.CRITICAL;
        };
    }

    /** What it does, or why it does not move, without its name, which is next to or above this text everywhere. */
    public static String state(BoatSnapshot boat) {
        String mark = switch (trouble(boat)) {
            case 3 -> "▲ ";
            case 2, 1 -> "△ ";
            default -> "";
        };
        String text = boat.why().text();
        String name = boat.boat() + " ";
        return mark + (text.startsWith(name) ? text.substring(name.length()) : text);
    }

    /** The same without its progress on the path, which is shown next to it, and without the numbers of missions. */
    static String brief(BoatSnapshot boat) {
        boolean isAddress = boat.boat().contains(":"); // of which the column of names has no room for the middle
        if (boat.why().cause() == BoatExplanation.Cause.NEVER_ANSWERED && isAddress) {
            return state(boat).replaceFirst("△ ", "△ " + boat.boat() + " · ");
        }
        return state(boat).replaceFirst(", \\d+ of \\d+ points visited", "").replaceAll("for mission \\d+, ", "for ");
    }

    /** Its charge in percent, or in a word where it reports none. */
    public static String battery(BoatSnapshot boat) {
        Optional<String> word = UnknownCharge.word(boat);
        if (word.isPresent()) {
            return word.get();
        }
        return boat.battery()
                .map(battery -> String.format(Locale.ROOT, "%.0f %%", battery.percent()))
                .orElse(UNKNOWN);
    }

    /** Its speed over ground in m/s; where it is carried, with the decimals of a drift. */
    public static String speed(BoatSnapshot boat) {
        return boat.speedWords().isEmpty() ? UNKNOWN : boat.speedWords();
    }

    /** How high it is above the place of its take-off, in m. */
    public static String altitude(BoatSnapshot boat) {
        return boat.pose()
                .map(pose ->
                        String.format(Locale.ROOT, "%.0f m", pose.position().altM()))
                .orElse(UNKNOWN);
    }

    /** A speed in m/s; one that is rounded to nothing has no sign. */
    public static String speed(double mps) {
        return String.format(Locale.ROOT, "%.1f m/s", Math.round(mps * 10) / 10.0);
    }

    /** The speed of a drift in m/s. */
    public static String drift(double mps) {
        return String.format(Locale.ROOT, "%.2f m/s", mps);
    }

    /** How far it is on its path. */
    public static String path(BoatSnapshot boat) {
        return boat.points() == 0 ? UNKNOWN : boat.visited() + " / " + boat.points();
    }

    /** How its link is, and since when nothing came. */
    public static String link(BoatSnapshot boat, long nowMillis) {
        return boat.why().cause() == BoatExplanation.Cause.NEVER_ANSWERED
                ? "none yet"
                : link(boat.link(), boat.heardAtMillis(), nowMillis);
    }

    /** How a link is, and since when nothing came over it. */
    public static String link(LinkState link, OptionalLong heardAtMillis, long nowMillis) {
        if (heardAtMillis.isEmpty()) {
            return "connecting";
        }
        String age = Age.words(nowMillis - heardAtMillis.getAsLong());
        return link == LinkState.LOST ? "lost " + age : age;
    }

    /** Whether what is known of it is old. */
    public static boolean isStale(BoatSnapshot boat, long nowMillis) {
        return boat.linkAgeMillis(nowMillis).orElse(Long.MAX_VALUE) > STALE_MS;
    }
}

package org.sami.crw.sim.link;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.OptionalDouble;
import org.sami.boat.link.LostLinkAction;

/**
 * The radio between a base ashore and the boats of a run in process, as an option says it: {@code loss=5,range=90,lost-link=return}.
 *
 * @param lossPercent percentage of the messages that never arrive, in each direction, 0 to {@value #MOST_LOSS_PERCENT}
 * @param rangeM how far from the base a boat still has a link, in metres; empty for everywhere
 * @param lostLink what boats do that have lost their link
 */
public record Radio(double lossPercent, OptionalDouble rangeM, LostLinkAction lostLink) {
    /** Reaches everywhere and loses nothing. */
    public static final Radio PERFECT = new Radio(0, OptionalDouble.empty(), LostLinkAction.HOLD);

    /** The greatest loss: with more, hardly any link comes about. */
    public static final int MOST_LOSS_PERCENT = 90;

    /** The shortest range, in metres. */
    public static final double SHORTEST_RANGE_M = 30;

    /** The longest range, in metres. */
    public static final double LONGEST_RANGE_M = 100_000;

    private static final String LOSS = "loss";
    private static final String RANGE = "range";
    private static final String LOST_LINK = "lost-link";
    private static final double PERCENT = 100;

    /** Refuses a radio over which no mission can be driven. */
    public Radio {
        Objects.requireNonNull(lostLink, "lostLink");
        if (!(lossPercent >= 0 && lossPercent <= MOST_LOSS_PERCENT)) {
            throw new IllegalArgumentException(
                    "a radio loses 0 to " + MOST_LOSS_PERCENT + " % of its messages, not " + lossPercent);
        }
        double metres = rangeM.orElse(SHORTEST_RANGE_M);
        if (!(metres >= SHORTEST_RANGE_M && metres <= LONGEST_RANGE_M)) {
            throw new IllegalArgumentException("a radio reaches 30 to 100000 m, not " + metres);
        }
    }

    /**
     * Reads {@code loss=PERCENT}, {@code range=METRES} and {@code lost-link=ACTION}, or some of them, with commas between them.
     *
     * @throws IllegalArgumentException naming what cannot be read
     */
    public static Radio parse(String text) {
        Radio radio = PERFECT;
        for (String part : text.strip().toLowerCase(Locale.ROOT).split(",", -1)) {
            String[] sides = part.strip().split("=", 2);
            radio = sides.length < 2 ? radio.with(part, "") : radio.with(sides[0].strip(), sides[1].strip());
        }
        return radio;
    }

    private Radio with(String name, String value) {
        return switch (name) {
            case LOSS -> new Radio(number(value), rangeM, lostLink);
            case RANGE -> new Radio(lossPercent, OptionalDouble.of(number(value)), lostLink);
            case LOST_LINK -> new Radio(lossPercent, rangeM, action(value));
            default ->
                throw new IllegalArgumentException("a radio is loss=PERCENT, range=METRES, lost-link=ACTION or "
                        + "some of them with commas; '" + name + "' is none of these");
        };
    }

    private static LostLinkAction action(String text) {
        return Arrays.stream(LostLinkAction.values())
                .filter(action -> word(action).equals(text))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "a boat that has lost its link does hold, return, continue or drift, not '" + text + "'"));
    }

    private static String word(LostLinkAction action) {
        return action.name().toLowerCase(Locale.ROOT);
    }

    private static double number(String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + text + "' is no number", e);
        }
    }

    /** The same as {@link #parse} reads it. */
    @Override
    public String toString() {
        List<String> parts = new ArrayList<>(List.of(LOSS + "=" + text(lossPercent)));
        rangeM.ifPresent(metres -> parts.add(RANGE + "=" + text(metres)));
        if (lostLink != PERFECT.lostLink) {
            parts.add(LOST_LINK + "=" + word(lostLink));
        }
        return String.join(",", parts);
    }

    private static String text(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
    }

    /** Whether it is as if none had been given. */
    public boolean isPerfect() {
        return equals(PERFECT);
    }

    /** Whether a boat at this distance from the base, in metres, has a link. */
    public boolean reaches(double distanceM) {
        return rangeM.isEmpty() || distanceM <= rangeM.getAsDouble();
    }

    /** A link over this radio that is otherwise the given one. */
    public PipeConfig over(PipeConfig link) {
        return lossPercent == 0
                ? link
                : new PipeConfig(link.latencyMs(), link.jitterMs(), lossPercent / PERCENT, link.isCoded());
    }
}

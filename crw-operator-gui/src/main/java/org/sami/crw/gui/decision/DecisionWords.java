package org.sami.crw.gui.decision;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalLong;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;

/** The text of a decision besides its question: who asks, for how long it has waited, what autonomy will do. */
final class DecisionWords {
    private static final long SECOND = 1000;
    private static final long MINUTE = 60;
    private static final int MOST_BOATS = 3;

    private DecisionWords() {}

    /** A time that passes: {@code 12 s}, {@code 3 min 05 s}, {@code 1 h 02 min}. */
    static String span(long millis) {
        long seconds = Math.max(0, millis) / SECOND;
        if (seconds < MINUTE) {
            return seconds + " s";
        }
        return seconds < MINUTE * MINUTE
                ? String.format(Locale.ROOT, "%d min %02d s", seconds / MINUTE, seconds % MINUTE)
                : String.format(Locale.ROOT, "%d h %02d min", seconds / MINUTE / MINUTE, seconds / MINUTE % MINUTE);
    }

    /** The same in one unit, for a column: {@code 12 s}, {@code 3 min}, {@code 2 h}. */
    static String brief(long millis) {
        long seconds = Math.max(0, millis) / SECOND;
        if (seconds < 2 * MINUTE) {
            return seconds + " s";
        }
        return seconds < 2 * MINUTE * MINUTE ? seconds / MINUTE + " min" : seconds / MINUTE / MINUTE + " h";
    }

    /** How long autonomy leaves to the operator, as {@link #brief}; {@code stopped} where its timer was stopped, a dash where it has none. */
    static String left(PendingDecision pending, long nowMillis) {
        OptionalLong left = pending.autonomyInMillis(nowMillis);
        if (left.isPresent()) {
            return brief(roundedUp(left.getAsLong()));
        }
        return pending.presentation().autonomy().isHeld() ? "stopped" : "–";
    }

    /** Who asks, in a few words: the mission by the name that it was given, and its plan where that is not the same. */
    static String mission(DecisionPresentation decision) {
        String mission = decision.asker().mission();
        String plan = decision.asker().planTitle();
        if (mission.isBlank()) {
            return plan.isBlank() ? "the system" : plan;
        }
        boolean named = !plan.isBlank() && !mission.equals(decision.asker().plan()) && !mission.equals(plan);
        return named ? mission + " · " + plan : plan.isBlank() ? mission : plan;
    }

    /** How urgent it is, as a mark before its question. */
    static String mark(Priority priority) {
        return switch (priority) {
            case CRITICAL -> "▲ ";
            case HIGH -> "△ ";
            default -> "";
        };
    }

    private static long roundedUp(long millis) {
        return millis + SECOND - 1;
    }

    /**
     * What is asked, as a heading: where the question is no more than its event's name and its place's, as {@code Operator Create Area (Draw
     * the area)}, the place says what is to be done. What the system asks about a mission begins with the mission's name.
     */
    static String heading(DecisionPresentation decision) {
        String place = decision.asker().placeName();
        String mission = decision.asker().mission();
        String title = decision.title();
        if (decision.decision().mission() == Ids.NONE && !mission.isBlank()) {
            return mission + ": " + title;
        }
        return !place.isBlank() && title.endsWith(" (" + place + ")") ? place : title;
    }

    /** Who asks, in one line: mission and place, as far as they are known. */
    static String asker(DecisionPresentation decision) {
        List<String> parts = new ArrayList<>(List.of(
                decision.asker().mission(),
                heading(decision).equals(decision.asker().placeName())
                        ? decision.asker().event()
                        : decision.asker().placeName()));
        parts.add(boats(decision));
        parts.removeIf(String::isBlank);
        return parts.isEmpty() ? "Asked by the system" : String.join(" · ", parts);
    }

    /** The few boats that it is about; empty text where it is about none in particular. */
    static String boats(DecisionPresentation decision) {
        return decision.map()
                .boats()
                .map(MapRelevance.Boats::boats)
                .filter(boats -> boats.size() <= MOST_BOATS)
                .map(boats -> String.join(", ", boats))
                .orElse("");
    }

    /** How long it has waited, and how urgent it is where that is not as usual. */
    static String age(PendingDecision pending, long nowMillis) {
        String waits = "asked " + span(pending.ageMillis(nowMillis)) + " ago";
        Priority priority = pending.decision().priority();
        return switch (priority) {
            case CRITICAL -> "▲ critical · " + waits;
            case HIGH -> "△ urgent · " + waits;
            default -> waits;
        };
    }

    /** What autonomy does with it, in one sentence; empty text where it does nothing and was never to. */
    static String autonomy(PendingDecision pending, long nowMillis) {
        DecisionPresentation decision = pending.presentation();
        OptionalLong left = decision.autonomy().remainingMillis(nowMillis);
        if (left.isPresent()) {
            return "Autonomy " + decision.autonomy().phrase() + " in " + span(roundedUp(left.getAsLong()));
        }
        return decision.autonomy().isHeld() ? "The timer was stopped: only you answer" : "";
    }
}

package org.sami.dreamm.profile;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.sami.spn.model.Action;
import org.sami.spn.model.Match;
import org.sami.spn.model.TokenKind;

/** The ids by which a profile names what is neither a command nor an item of the palette, and the search for names that nothing has. */
public final class ProfileIds {
    /** The mark on edges without requirement. */
    public static final String MISSING_REQUIREMENT = "net-missing-requirement";

    /** The choice of what comes with an event; where it is hidden, events are added alone. */
    public static final String SEQUENCES = "wizard-sequence";

    /** An edge's requirements; where they are hidden, the net does not write them either. */
    public static final String EDGE = "inspector-edge";

    /** What is dragged: vertices in the net, items onto it, lines of the mission tree. */
    private static final List<String> GESTURES = List.of("net-move", "net-drop", "plan-move");

    /** Fields, choices and buttons of the panels: the names of the components, without the numbers and names of what they are about. */
    private static final List<String> FIELDS = List.of(
            "search-everything-text",
            "palette-search",
            SEQUENCES,
            "inspector-name",
            "inspector-start",
            "inspector-end",
            "inspector-ends-shared",
            "inspector-wait-for",
            "inspector-mode",
            "inspector-disabled",
            "inspector-frame-title",
            "inspector-frame-color",
            "inspector-locked",
            EDGE,
            "inspector-fix",
            "inspector-add-event",
            "inspector-implied-generic",
            "inspector-add-requirement",
            "inspector-propose-requirement",
            "inspector-remove-requirement",
            "inspector-compute",
            "inspector-match",
            "inspector-count",
            "inspector-action",
            "inspector-quantity",
            "inspector-kind",
            "inspector-task",
            "event",
            "event-up",
            "event-reset",
            "event-delete",
            "event-field",
            "event-field-source",
            "event-field-sources",
            "event-field-value",
            "event-field-variable",
            "event-field-write",
            "event-field-only",
            "event-markups",
            "event-add-markup",
            "markup-add",
            "markup-remove",
            "sub-mission",
            "sub-mission-plan",
            "sub-mission-shared",
            "sub-mission-task",
            "sub-mission-variable",
            "sub-mission-open",
            "sub-mission-delete",
            "plan-name",
            "plan-description",
            "plan-tasks",
            "plan-task",
            "plan-task-value",
            "plan-task-remove",
            "plan-add-task",
            "plan-variables",
            "plan-variable",
            "plan-variable-remove",
            "plan-add-variable",
            "project-variables",
            "project-variable",
            "project-variable-remove",
            "project-add-variable",
            "issues-show-error",
            "issues-show-warning",
            "issues-show-note",
            "issues-only-open",
            "issues-filter",
            "issues-show-all",
            "deep-checks",
            "count-errors",
            "count-warnings",
            "try-robots",
            "try-locations",
            "try-operator-answers",
            "try-robots-answer",
            "try-happen",
            "try-reject",
            "try-tab-steps",
            "try-tab-state",
            "try-tab-marking",
            "try-tab-cases",
            "marking-generic",
            "marking-token",
            "marking-value",
            "marking-clear",
            "case-name",
            "case-keep",
            "case-play",
            "case-remove",
            "query-name",
            "query-text",
            "query-expected",
            "query-keep",
            "replay-speed");

    private static final List<String> SOURCES = List.of("value", "asked", "locked", "variable", "task");

    /** Beginnings of ids that only a project or a check knows in full. */
    private static final List<String> OPEN = List.of("palette-sub-mission-", "finding-");

    private ProfileIds() {}

    /** All of them, in order. */
    public static Set<String> fixed() {
        Set<String> ids = new LinkedHashSet<>(GESTURES);
        ids.add(MISSING_REQUIREMENT);
        ids.addAll(FIELDS);
        SOURCES.forEach(source -> ids.add("event-source-" + source));
        Stream.of(TokenKind.values()).forEach(kind -> {
            if (kind != TokenKind.SUB_MISSION_TOKENS) {
                ids.add(in(kind));
            }
            ids.add(out(kind));
        });
        Stream.of(Match.values()).forEach(match -> ids.add(of(match)));
        Stream.of(Action.values()).forEach(action -> ids.add(of(action)));
        ids.add(quantity(true));
        ids.add(quantity(false));
        return ids;
    }

    /** A kind of tokens in requirements of edges that lead to transitions. */
    public static String in(TokenKind kind) {
        return "requirement-in-" + word(kind);
    }

    /** A kind of tokens in requirements of edges that lead to places. */
    public static String out(TokenKind kind) {
        return "requirement-out-" + word(kind);
    }

    /** How many tokens an edge to a transition asks for. */
    public static String of(Match match) {
        return "requirement-match-" + word(match);
    }

    /** What becomes of tokens on an edge to a place. */
    public static String of(Action action) {
        return "requirement-action-" + word(action);
    }

    /** All tokens, or so many. */
    public static String quantity(boolean all) {
        return "requirement-quantity-" + (all ? "all" : "number");
    }

    /** Findings of a code: hidden ones are not shown, counted or drawn. */
    public static String finding(String code) {
        return "finding-" + code.toLowerCase(Locale.ROOT);
    }

    private static String word(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /**
     * What is wrong with the names in a profile: one sentence for the first that names nothing.
     *
     * @param others the ids of commands, panels and of what the palette offers
     */
    public static Optional<String> unknown(Profile profile, Collection<String> others) {
        Set<String> known = new TreeSet<>(fixed());
        known.addAll(others);
        return Stream.of(profile.hide(), profile.lock(), profile.keep())
                .flatMap(List::stream)
                .filter(pattern -> !names(pattern, known))
                .findFirst()
                .map(pattern -> "the profile " + profile.name() + " names \"" + pattern
                        + "\", which this window does not have" + likely(pattern, known));
    }

    private static boolean names(String pattern, Set<String> known) {
        boolean open = OPEN.stream().anyMatch(pattern::startsWith);
        return open || known.stream().anyMatch(id -> Profile.fits(pattern, id));
    }

    /** The ids that have most of the words of a pattern. */
    private static String likely(String pattern, Set<String> known) {
        List<String> words = List.of(pattern.replace("*", "").split("-"));
        long most = 0;
        List<String> best = new ArrayList<>();
        for (String id : known) {
            long count = List.of(id.split("-")).stream().filter(words::contains).count();
            if (count > most) {
                most = count;
                best.clear();
            }
            if (count == most && count > 0 && best.size() < 3) {
                best.add(id);
            }
        }
        return best.isEmpty() ? "" : "; likely: " + String.join(", ", best);
    }
}

package org.sami.dreamm;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;

/**
 * In which lesson the course teaches each thing that the editor has: the rows of the thesis's Table 4 (appendix .4.1), with the lessons of
 * this course, and what of this editor that table does not have. Written by hand, apart from the modes that it is held against. Ids are those
 * of {@link VisibleThings}; of patterns that fit, the longest counts.
 */
final class Taught {
    private static final String NEVER = "";

    private static final Map<String, String> FIRST = new LinkedHashMap<>();

    private Taught() {}

    private static void in(String lesson, String... patterns) {
        for (String pattern : patterns) {
            FIRST.put(pattern, lesson);
        }
    }

    static {
        // Files, edits and views, as in any program; the net itself: label, delete, start, end, blank place and
        // transition
        in("02-places", "menu:project-save", "menu:project-save-as", "menu:end", "menu:undo", "menu:redo");
        in("02-places", "menu:plan-export-*", "menu:theme-*", "menu:scale-*", "menu:rows-high", "menu:panels-reset");
        in("02-places", "menu:command-search", "menu:help-*", "menu:words-*", "menu:learn-*", "menu:show-*");
        in("02-places", "menu:net-cut", "menu:net-copy", "menu:net-paste*", "menu:net-duplicate", "menu:net-delete");
        in("02-places", "menu:net-select-all", "menu:net-rename", "menu:rename", "menu:usages-find");
        in("02-places", "menu:search-everything", "menu:net-set-start", "menu:net-set-end", "menu:net-snap");
        in("02-places", "menu:net-add-place", "menu:net-add-transition", "menu:net-connect");
        in("02-places", "menu:net-layout-*", "menu:net-align-*");
        in("02-places", "menu:panel-mission-tree", "menu:panel-model-view", "menu:panel-palette");
        in("02-places", "menu:panel-inspector", "menu:panel-learn");
        in("02-places", "menu:folder-new", "menu:tree-delete", "menu:plan-up", "menu:plan-down");
        in("02-places", "palette-group-blank", "palette-blank-*", "palette-search", "search-everything-text");
        in("02-places", "inspector-name", "inspector-start", "inspector-end", "plan-name", "plan-description");

        // Places and transitions with events; fields are values
        in("03-events", "palette-group-*", "inspector-add-event", "event", "event-up", "event-reset", "event-delete");
        in("03-events", "event-field", "event-field-source", "event-field-value", "source:value", "source:not given*");
        in("03-events", "menu:net-show-events");

        in("04-generic-tokens", "menu:net-show-tokens");

        // Edit in and out tokens; Generic, Implied Generic, None, LessThan, GreaterThan, EqualTo, Number, Take,
        // Consume, Add; icon and counter
        in("05-requirements", "inspector-edge", "inspector-implied-generic", "inspector-add-requirement");
        in("05-requirements", "inspector-remove-requirement", "inspector-match", "inspector-count", "inspector-action");
        in("05-requirements", "inspector-quantity", "inspector-kind", "kind:Generic");
        in("05-requirements", "match:No", "match:<", "match:≥", "match:=", "quantity:n", "quantity:All");
        in("05-requirements", "action:Take", "action:Consume", "action:Add");
        in("05-requirements", "count-errors", "menu:panel-issues", "menu:issue-*", "issues-*");
        in("05-requirements", "menu:net-show-requirements");

        // AnyProxy, Relevant, All
        in("06-robots", "kind:Proxy", "kind:Relevant", "match:All");

        // Read variable name, Write variable name, Editable; Token
        in("08-variables", "event-field-variable", "event-field-write", "plan-variable*", "plan-add-variable");
        in("08-variables", "source:asked*", "source:answer or variable", "kind:Token");

        // AnyTask; what comes with an event, and who waits for whom
        in("09-tasks", "kind:Task", "source:@task", "inspector-wait-for", "wizard-sequence");

        // Edit Markup
        in("10-markup", "event-markups", "event-add-markup", "markup-*", "markup:*", "menu:net-show-markups");

        in("final-panoramas", "menu:panel-try-out", "menu:try-*", "try-*", "case-*", "marking-*");

        // Sub-missions, New mission; an answer that is taken for one value only
        in("11-sub-missions", "palette-group-sub-missions", "palette-sub-mission-*", "sub-mission*");
        in("11-sub-missions", "kind:Sub-mission", "menu:plan-new", "menu:plan-clone", "event-field-only");

        // Recovery parts
        in("12-contingencies", "inspector-mode", "menu:net-mode-*", "menu:net-recovery", "menu:net-mark-*");
        in("12-contingencies", "menu:net-extract");

        // Roles, None, TaskClass: tasks by name; and tools that the course does without
        in(NEVER, "palette-group-roles", "palette-role-*", "kind:named Task", "kind:No Condition");
        in(NEVER, "kind:Enter With Nobody", "inspector-task", "plan-task*", "plan-add-task", "project-*");
        in(NEVER, "menu:project-new", "menu:project-open", "menu:project-save-folder", "menu:library-open");
        in(NEVER, "menu:import-*", "menu:plan-compare-*", "menu:pattern-*", "menu:replay-*", "menu:panel-replay");
        in(NEVER, "menu:panel-queries", "menu:query-*", "query-*");
        in(
                NEVER,
                "menu:panel-comparison",
                "menu:deep-*",
                "menu:edge-suggest",
                "menu:issue-fix",
                "menu:net-append",
                "menu:net-disable");
        in(NEVER, "menu:net-add-note", "menu:net-add-frame", "inspector-frame-*", "inspector-disabled");
        in(NEVER, "inspector-locked", "inspector-compute", "inspector-propose-requirement", "inspector-ends-shared");
        in(NEVER, "inspector-fix", "count-warnings", "deep-*", "issues-show-warning", "issues-show-note", "replay-*");
    }

    /** Why something must not be seen in a lesson; empty where it was taught there, or before. */
    static Optional<String> whyNot(String thing, String lesson, Course course) {
        if (thing.startsWith("event:")) { // the course says itself where it introduces events
            return Optional.of(thing + " is not introduced yet")
                    .filter(why -> !course.eventsKnown(lesson).contains(thing.substring("event:".length())));
        }
        List<String> order = course.lessons().stream().map(Lesson::id).toList();
        Optional<String> pattern = FIRST.keySet().stream()
                .filter(each -> each.endsWith("*")
                        ? thing.startsWith(each.substring(0, each.length() - 1))
                        : thing.equals(each))
                .max((a, b) -> Integer.compare(a.length(), b.length()));
        if (pattern.isEmpty()) {
            return Optional.of(thing + " is in no lesson's row");
        }
        String first = FIRST.getOrDefault(pattern.get(), NEVER);
        if (first.equals(NEVER)) {
            return Optional.of(thing + " is taught in no lesson");
        }
        return order.indexOf(first) <= order.indexOf(lesson)
                ? Optional.empty()
                : Optional.of(thing + " is taught in " + first);
    }
}
